eval canvas(300, 220)
eval axis_names("time  [s]", "out of place  [cm]")
set xrange [0:1.5]
set yrange [-11:11]
set xtics 0.5
set ytics 5
set xzeroaxis ls CONTEXT
plot file("undamped") using col("t"):(100 * val("x")) with lines ls CONTEXT, \
     file("suspension") using col("t"):(100 * val("x")) with lines ls FIRST
