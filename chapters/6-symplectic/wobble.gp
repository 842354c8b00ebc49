eval axis_names("time  [s]", "energy, relative to the start")
set xrange [0:1]
set yrange [0.6:1.6]
set xtics 0.25
set ytics 0.2
set label 1 "Euler" at 0.105,1.5 left tc ls EULER
set label 2 "symplectic Euler" at 0.5,1.29 center tc ls SYMPLECTIC_EULER
set arrow 1 from 0.86,1.43 to 0.86,1.01 nohead ls CONTEXT
set label 3 "its shadow energy" at 0.995,1.47 right tc ls FIRST
plot file("wobble") using col("t"):(val("Euler") < 1.7 ? val("Euler") : NaN) with linespoints ls EULER lw 1.6, \
     file("wobble") using col("t"):col("shadow") with lines ls FIRST, \
     file("wobble") using col("t"):col("symplectic Euler") with linespoints ls SYMPLECTIC_EULER lw 1.4 ps 0.45, \
     file("wobble") every 3 using col("t"):col("symplectic Euler"):(sprintf("at %.2f s: energy %.3f, shadow %.3f", val("t"), val("symplectic Euler"), val("shadow"))) with labels hypertext point ls SYMPLECTIC_EULER ps 0.45
