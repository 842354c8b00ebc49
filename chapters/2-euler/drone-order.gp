eval axis_names("steps per second", "largest error  [m] or [m/s]")
set logscale xy
set xrange [12:2500]
set yrange [0.005:8]
set xtics (15, 30, 60, 120, 240, 480, 960, 1920)
if (NARROW) set xtics (15, 60, 240, 960)
set ytics (0.01, 0.1, 1)
unset mxtics
set label 1 "position" at 36,1.15 left tc ls EULER
set label 2 "velocity" at 26,0.42 right tc ls EULER
set label 3 "slope −1" at 1000,0.13 left tc ls EXACT
plot 100/x with lines ls CONTEXT, \
     file("order") using col("steps per second"):col("error") with linespoints ls EULER, \
     file("order") using col("steps per second"):col("velocity error") with linespoints ls EULER dt (5,4) pt 6, \
     file("order") using col("steps per second"):col("error"):(sprintf("%d steps a second: %.3g m", val("steps per second"), val("error"))) with labels hypertext point ls EULER, \
     file("order") using col("steps per second"):col("velocity error"):(sprintf("%d steps a second: %.3g m/s", val("steps per second"), val("velocity error"))) with labels hypertext point ls EULER
