eval axis_names("time  [s]", "place of the camera  [m]")
set xrange [0:0.4]
set yrange [-0.1:2.6]
set xtics 0.1
set ytics 1
set label 1 "Euler's method" at 0.175,2.3 left tc ls EULER
set label 2 "exact" at 0.05,0.36 left tc ls SPRING_EXACT
set label 3 "target" at 0.385,NARROW ? 1.2 : 1.14 right tc ls LIMIT
late = cell("hitch", 3, "t")
again = cell("hitch", 4, "t")
set arrow 1 from late,0 to again,0 heads ls CONTEXT
set label 4 "the late frame" at again + 0.006,0.1 left tc ls EXACT
omega = exact("hitch-omega")
plot 1 with lines ls LIMIT, \
     1 - (1 + omega*x)*exp(-omega*x) with lines ls CONTEXT, \
     file("hitch") using col("t"):col("Euler") with linespoints ls EULER lw 1.4, \
     file("hitch") using col("t"):col("exact") with points ls SPRING_EXACT ps 0.8, \
     file("hitch") using col("t"):col("Euler"):(sprintf("Euler, at %.2f s: %.3f m", val("t"), val("Euler"))) with labels hypertext point ls EULER, \
     file("hitch") using col("t"):col("exact"):(sprintf("exact, at %.2f s: %.3f m", val("t"), val("exact"))) with labels hypertext point ls SPRING_EXACT ps 0.8
