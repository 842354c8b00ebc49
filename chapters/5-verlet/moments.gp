eval axis_names("time  [s]", "velocity  [m/s]")
set xrange [0:1.25]
set yrange [NARROW ? -11.5 : -8.5:8.5]
set xtics 0.25
set ytics 4
set label 1 "velocity Verlet" at 0.87,7.2 left tc ls VELOCITY_VERLET
set label 2 "last distance over h, as of now" at 0.48,-4.4 left tc ls THIRD
set label 3 "the same, as of half a step ago" at 0.6,-6.7 left tc ls FIRST
if (NARROW) set label 2 "as of now" at 0.52,-4.2; set label 3 "as of half a step ago" at 0.25,-9.6
plot file("swing-exact") using col("t"):col("v") with lines ls EXACT, \
     file("moments") using col("half a step ago"):col("last distance over h"):(val("t")-val("half a step ago")):(0) with vectors nohead ls GRID lw 1.4, \
     file("moments") using col("t"):col("last distance over h") with points ls THIRD pt 8 ps 0.9, \
     file("moments") using col("half a step ago"):col("last distance over h") with points ls FIRST pt 1 ps 0.9, \
     file("moments") using col("t"):col("velocity Verlet") with points ls VELOCITY_VERLET ps 0.9, \
     file("moments") using col("t"):col("last distance over h"):(sprintf("at %.3f s the last distance over h is %.2f m/s, velocity Verlet's %.2f", val("t"), val("last distance over h"), val("velocity Verlet"))) with labels hypertext point ls THIRD pt 8 ps 0.9
