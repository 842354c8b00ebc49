eval axis_names("time  [s]", "height  [m]")
set xrange [0:4.15]
set yrange [0:100]
set xtics 1
set ytics 25
set label 1 "true" at 3.2,75 right tc ls EXACT
set label 2 NARROW ? "Euler" : "ten Euler steps" at NARROW ? 2.75 : 1.9,NARROW ? 18 : 4 left tc ls EULER
set label 3 NARROW ? "constant" : "constant acceleration" at 4.1,NARROW ? 36 : 31 right tc ls CONSTANT_ACCELERATION
plot file("rocket") using col("t"):col("as if constant") with lines ls SECOND, \
     file("rocket") using col("t"):col("exact") with lines ls EXACT, \
     file("rocket-euler") using col("t"):col("height") with linespoints ls EULER, \
     file("rocket-euler") using col("t"):col("height"):(sprintf("Euler at %.1f s: %.1f m", val("t"), val("height"))) with labels hypertext point ls EULER
