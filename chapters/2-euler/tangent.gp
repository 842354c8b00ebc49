eval NARROW ? canvas(400, 330) : canvas(640, 470)
eval axis_names("x  [m]", "y  [m]")
set size ratio -1
set xrange [-16:16]
set yrange [-3.5:19]
set xtics 10
set ytics 10
set parametric
set trange [0:2*pi]
unset grid
set label 1 "{/:Italic r}" at 4.6,-1.1 center tc ls EXACT
set label 2 "{/:Italic h v}" at 10.6,4 left tc ls EULER
set label 3 "outside" at 10.6,8.4 left tc ls EULER
set arrow 1 from 0,0 to 10,0 nohead ls CONTEXT
set arrow 2 from 0,0 to cell("tangent", 2, "x"),cell("tangent", 2, "y") nohead ls CONTEXT
set arrow 3 from 9,0 to 9,1 nohead ls CONTEXT
set arrow 4 from 9,1 to 10,1 nohead ls CONTEXT
circle = exact("circle")
plot circle*cos(t), circle*sin(t) with lines ls EXACT, \
     file("tangent") using col("x"):col("y") with linespoints ls EULER ps 0.8, \
     "+" every 1000 using (0):(0) with points ls CONTEXT pt 7 ps 0.8, \
     file("tangent") using col("x"):col("y"):(sprintf("after %.0f s: %.2f m from the tower", val("t"), sqrt(val("x")**2 + val("y")**2))) \
       with labels hypertext point ls EULER ps 0.8
