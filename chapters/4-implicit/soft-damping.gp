eval axis_names("{/:Italic hω} asked for", "damping ratio that you get")
set xrange [0:3.05]
set yrange [0:1]
set xtics 0.5
set ytics 0.2
array asked = [0, 0.2, 0.7]
damping(i) = sprintf("%g", asked[i])
set label 1 "asked for ζ = ".damping(3) at 1.2,0.95 left tc ls THIRD
set label 2 damping(2) at 1.9,NARROW ? 0.745 : 0.72 center tc ls SECOND
set label 3 damping(1) at 1.9,NARROW ? 0.49 : 0.5 center tc ls BACKWARD_EULER
set label 4 "½ {/:Italic hω}" at 0.62,0.22 left tc ls EXACT
tip(i) = sprintf("hω = %.1f, asked for %s: %.3f", val("hω"), damping(i), val("asked ".damping(i)))
half(x) = x < 0.95 ? x/2 : NaN
plot half(x) with lines ls EXACT, \
     file("soft") using col("hω"):col("asked ".damping(1)) with linespoints ls BACKWARD_EULER, \
     file("soft") using col("hω"):col("asked ".damping(2)) with linespoints ls SECOND, \
     file("soft") using col("hω"):col("asked ".damping(3)) with linespoints ls THIRD, \
     file("soft") using col("hω"):col("asked ".damping(1)):(tip(1)) with labels hypertext point ls BACKWARD_EULER, \
     file("soft") using col("hω"):col("asked ".damping(2)):(tip(2)) with labels hypertext point ls SECOND, \
     file("soft") using col("hω"):col("asked ".damping(3)):(tip(3)) with labels hypertext point ls THIRD
