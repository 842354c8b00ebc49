eval canvas(300, 220)
eval axis_names("time  [s]", "height  [m]")
set xrange [0:4.2]
set yrange [0:100]
set xtics 1
set ytics 25
plot file("rocket") using col("t"):col("x") with lines ls FIRST, \
     file("off-beat") using col("t"):col("x") with lines ls SECOND, \
     file("off-beat") every ::1::1 using col("t"):col("x") with points ls SECOND ps 0.8
