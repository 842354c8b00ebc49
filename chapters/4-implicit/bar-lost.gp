eval axis_names("frame", "distance of the trailer from its place")
set logscale y
set xrange [0:10.2]
set yrange [1e-14:1e26]
set xtics 2
set ytics ("1 nm" 1e-9, "1 mm" 1e-3, "1 km" 1e3, "the Sun" 1.5e11, "a light-year" 9.46e15, "Andromeda" 2.4e22)
set lmargin NARROW ? 10 : 10.5
unset mytics
set label 1 "RK4" at 5.6,NARROW ? 1e16 : 5e15 right tc ls RK4
set label 2 NARROW ? "symplectic" : "symplectic Euler" at 10.1,1e9 right tc ls SYMPLECTIC_EULER
set label 3 "Euler" at 10.1,NARROW ? 1 : 1e2 right tc ls EULER
set label 4 NARROW ? "backward" : "backward Euler" at NARROW ? 1.2 : 0.4,NARROW ? 1e-11 : 1e-9 left tc ls BACKWARD_EULER
set label 5 NARROW ? "true" : "how far the true one swings" at 6.2,1e-4 left tc ls EXACT
plot 1e-3*exp(-x) with lines ls EXACT, \
     file("bar") using col("frame"):col("Euler") with linespoints ls EULER, \
     file("bar") using col("frame"):col("symplectic Euler") with linespoints ls SYMPLECTIC_EULER, \
     file("bar") using col("frame"):col("RK4") with linespoints ls RK4, \
     file("bar") using col("frame"):col("backward Euler") with linespoints ls BACKWARD_EULER, \
     file("bar") using col("frame"):col("Euler"):(sprintf("Euler, frame %d: %.2g m", val("frame"), val("Euler"))) with labels hypertext point ls EULER, \
     file("bar") using col("frame"):col("symplectic Euler"):(sprintf("symplectic Euler, frame %d: %.2g m", val("frame"), val("symplectic Euler"))) with labels hypertext point ls SYMPLECTIC_EULER, \
     file("bar") using col("frame"):col("RK4"):(sprintf("RK4, frame %d: %.2g m", val("frame"), val("RK4"))) with labels hypertext point ls RK4, \
     file("bar") using col("frame"):col("backward Euler"):(sprintf("backward Euler, frame %d: %.2g m", val("frame"), val("backward Euler"))) with labels hypertext point ls BACKWARD_EULER
