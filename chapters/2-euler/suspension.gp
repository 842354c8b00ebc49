eval axis_names("time  [s]", "stretch  [m]")
set xrange [0:1.5]
set yrange [-0.2:0.2]
set xtics 0,0.25
set ytics 0.1
inside = number("suspension-inside")
outside = number("suspension-outside")
set label 1 outside.": grows" at 1.48,0.17 right tc ls EULER
set label 2 inside.": dies away" at 1.48,-0.17 right tc ls EULER
set label 3 "true" at 0.63,-0.165 center tc ls EXACT
set arrow 3 from 0.63,-0.145 to 0.63,0.02 nohead ls CONTEXT
plot file("suspension-outside") using col("t"):col("x") with linespoints ls EULER dt (2,3) pt 6 lw 1.2 ps 0.4, \
     file("suspension-exact") using col("t"):col("x") with lines ls EXACT, \
     file("suspension-inside") using col("t"):col("x") with linespoints ls EULER lw 1.4 ps 0.35, \
     file("suspension-outside") every 4 using col("t"):col("x"):(sprintf("%s, at %.3f s: %.3f m", outside, val("t"), val("x"))) with labels hypertext point ls EULER pt 6 ps 0.4, \
     file("suspension-inside") every 4 using col("t"):col("x"):(sprintf("%s, at %.3f s: %.3f m", inside, val("t"), val("x"))) with labels hypertext point ls EULER ps 0.35
