eval canvas(300, 220)
eval axis_names("across  [m]", "height  [m]")
set xrange [-0.7:3.4]
set yrange [0:1.5]
set xtics 1
set ytics 0.5
plot file("jump") every 20::1 using col("x"):col("y") with linespoints ls FIRST ps 0.5, \
     file("running-jump") using col("x"):col("y") with lines ls SECOND lw 1.4, \
     file("running-jump") every 20::1 using col("x"):col("y") with points ls SECOND ps 0.5
