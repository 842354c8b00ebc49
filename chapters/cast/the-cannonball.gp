eval canvas(300, 200)
eval axis_names("across  [m]", "height  [m]")
set xrange [0:260]
set yrange [0:60]
set xtics 100
set ytics 20
plot file("cannonball") using col("x"):col("y") with lines ls CONTEXT, \
     file("cannonball") every 20::1 using col("x"):col("y") with points ls FIRST ps 0.6
