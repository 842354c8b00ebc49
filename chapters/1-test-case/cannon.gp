eval axis_names("across  [m]", "height  [m]")
set xrange [0:255]
set yrange [-1.5:57]
set xtics 50
set ytics 0,10
set label 1 "in a vacuum: a formula" at 122,53 center tc ls EXACT
set label 2 "in air: steps" at 104,14.5 left tc ls SECOND
plot 30.0/40*x - 9.81/2*(x/40.0)**2 with lines ls EXACT, \
     file("cannon-in-air") using col("x"):col("y") with lines ls SECOND, \
     file("cannon") using col("x"):col("y") with points ls EXACT pt 7 ps 0.7, \
     file("cannon") using col("x"):col("y"):(sprintf("after %.2f s: %.1f m across, %.1f m up", val("t"), val("x"), val("y"))) \
       with labels hypertext point ls EXACT pt 7 ps 0.7
