eval NARROW ? canvas(400, 410) : canvas(560, 560)
eval axis_names("x  [m]", "y  [m]")
set size ratio -1
set xrange [-17:17]
set yrange [-17:17]
set xtics 10
set ytics 10
set label 1 "should be on this" at 0,-3 center tc ls EXACT
set parametric
set trange [0:2*pi]
set label 2 "start" at 8.9,0.9 right tc ls EULER
set label 3 "fence" at 11.5,14.5 left tc ls LIMIT
set arrow 3 from 12.5,13.4 to 8.6,8.6 nohead lc rgb "#000008"
circle = exact("circle")
fence = exact("fence")
plot circle*cos(t), circle*sin(t) with lines ls EXACT, \
     file("spiral") every 8 using col("x"):col("y") with lines ls EULER lw 1.4, \
     fence*cos(t), fence*sin(t) with lines ls LIMIT lw 2.6, \
     file("spiral") every 120 using col("x"):col("y") with points ls EULER ps 0.35, \
     "+" every 1000 using (0):(0) with points ls CONTEXT pt 7 ps 0.8, \
     file("spiral") every 120 using col("x"):col("y"):(sprintf("after %.0f s: %.2f m from the tower", val("t"), val("distance"))) \
       with labels hypertext point ls EULER ps 0.35
