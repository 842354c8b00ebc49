eval axis_names("time  [s]", "how far open")
set xrange [0:2]
set yrange [-0.45:1.25]
set xtics 0.5
set ytics 0.5
inside = number("door-inside")
outside = number("door-outside")
set label 1 outside at 0.99,1.08 left tc ls EULER
set label 2 inside at 1.5,0.33 left tc ls EULER
set label 3 "true" at 0.3,0.86 left tc ls EXACT
plot file("door-outside") using col("t"):col("x") with linespoints ls EULER dt (2,3) pt 6 lw 1 ps 0.4, \
     file("door-inside") using col("t"):col("x") with linespoints ls EULER lw 1.2 ps 0.35, \
     file("door-exact") using col("t"):col("x") with lines ls EXACT, \
     file("door-outside") using col("t"):(abs(val("x")) < 2 ? val("x") : NaN):(sprintf("%s, at %.2f s: %.3f", outside, val("t"), val("x"))) with labels hypertext point ls EULER pt 6 ps 0.4, \
     file("door-inside") every 4 using col("t"):col("x"):(sprintf("%s, at %.2f s: %.3f", inside, val("t"), val("x"))) with labels hypertext point ls EULER ps 0.35
