eval axis_names("time  [s]", "height  [m]")
set xrange [0:15.5]
set yrange [0:4]
set xtics 3
set ytics 1
set label 1 "Euler" at NARROW ? 1.6 : 2.5,3.5 center tc ls EULER
set label 2 "exact step" at NARROW ? 6 : 7.5,3.5 center tc ls EXACT
set label 3 "symplectic Euler" at NARROW ? 11.8 : 12.5,3.5 center tc ls SYMPLECTIC_EULER
plot file("bounce-exact") using col("t"):col("height") with lines ls EXACT, \
     file("bounce-euler") using col("t"):col("height") with lines ls EULER lw 1.6, \
     file("bounce-symplectic") using col("t"):col("height") with lines ls SYMPLECTIC_EULER lw 1.6
