eval canvas(300, 200)
eval axis_names("time  [s]", "out of place  [mm]")
set xrange [0:0.06]
set yrange [-1.1:1.1]
set xtics 0.02
set ytics 0.5
set xzeroaxis ls CONTEXT
plot file("bar") using col("t"):(1000 * val("x")) with lines ls FIRST
