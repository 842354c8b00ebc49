eval axis_names("time  [s]", "energy of the spin over that of the throw")
set xrange [0:10]
set yrange [0:4]
set xtics 2
set ytics 1
set label 1 "Euler" at 2.75,3.3 left tc ls EULER
set label 2 "backward Euler" at 4.2,0.47 left tc ls BACKWARD_EULER
set label 3 "trapezoid" at 7.4,1.17 left tc ls TRAPEZOID
set label 4 "true" at 5.2,1.17 left tc ls EXACT
plot 1 with lines ls EXACT, \
     file("spin") using col("t"):(val("Euler") < 5 ? val("Euler") : NaN) with lines ls EULER, \
     file("spin") using col("t"):col("backward Euler") with lines ls BACKWARD_EULER, \
     file("spin") using col("t"):col("trapezoid") with lines ls TRAPEZOID lw 1.6, \
     file("spin") every 30 using col("t"):(val("Euler") < 5 ? val("Euler") : NaN):(sprintf("Euler, %.1f s: %.2f", val("t"), val("Euler"))) with labels hypertext point ls EULER ps 0.3, \
     file("spin") every 30 using col("t"):col("backward Euler"):(sprintf("backward Euler, %.1f s: %.3f", val("t"), val("backward Euler"))) with labels hypertext point ls BACKWARD_EULER ps 0.3, \
     file("spin") every 30 using col("t"):col("trapezoid"):(sprintf("trapezoid, %.1f s: %.4f", val("t"), val("trapezoid"))) with labels hypertext point ls TRAPEZOID ps 0.3
