eval canvas(300, 220)
eval axis_names("time  [s]", "height  [m]")
set xrange [0:2.05]
set yrange [-8:0.4]
set xtics 0.5
set ytics 2
plot file("leaf") using col("t"):col("x") with lines ls CONTEXT, \
     file("leaf") every 15::1 using col("t"):col("x") with points ls FIRST ps 0.6
