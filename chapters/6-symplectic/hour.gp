eval axis_names("time  [min]", "distance from the tower  [m]")
set logscale y
set xrange [0:60]
set yrange [1:3e10]
set xtics 15
set ytics ("10" 10, "10^{3}" 1e3, "10^{5}" 1e5, "10^{7}" 1e7, "10^{9}" 1e9)
unset mytics
set label 1 "to the moon" at 4,2.5e9 left tc ls LIMIT
set label 2 "Euler" at NARROW ? 29 : 31,1.2e6 right tc ls EULER
set label 3 "two lines swapped" at 45,35 center tc ls SYMPLECTIC_EULER
plot exact("moon") with lines ls LIMIT, \
     file("hour") every 4::1 using col("minute"):col("Euler") with linespoints ls EULER ps 0.45, \
     file("hour") every 4::1 using col("minute"):col("symplectic Euler") with linespoints ls SYMPLECTIC_EULER ps 0.4, \
     file("hour") every 4::1 using col("minute"):col("Euler"):(sprintf("Euler after %.0f min: %.3g m", val("minute"), val("Euler"))) with labels hypertext point ls EULER ps 0.45, \
     file("hour") every 4::1 using col("minute"):col("symplectic Euler"):(sprintf("symplectic Euler after %.0f min: %.3f m", val("minute"), val("symplectic Euler"))) with labels hypertext point ls SYMPLECTIC_EULER ps 0.4
