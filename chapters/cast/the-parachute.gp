eval canvas(300, 220)
eval axis_names("time  [s]", "speed  [m/s]")
set xrange [0:1.5]
set yrange [0:52]
set xtics 0.5
set ytics 10
plot file("parachute") using col("t"):col("speed") with lines ls FIRST
