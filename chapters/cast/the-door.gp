eval canvas(300, 200)
eval axis_names("time  [s]", "out of place  [m]")
set xrange [0:4]
set yrange [0:1.05]
set xtics 1
set ytics 0.5
set xzeroaxis ls CONTEXT
plot file("door") using col("t"):col("x") with lines ls FIRST
