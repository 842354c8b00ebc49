eval NARROW ? canvas(400, 430) : canvas(560, 600)
eval axis_names("x  [m]", "y  [m]")
set size ratio -1
# A turn of 129 steps, from a farthest point to the next, where both ends meet without a kink.
farthest = 7666
passed = cell("turning", farthest, "t")
set xrange [-19:8]
set yrange [-12:18]
set xtics 10
set ytics 10
set parametric
set trange [0:2*pi]
set label 1 "should be here" at -6,-6.2 center tc ls EXACT
set label 2 sprintf("after %.0f turns", ceil(passed/exact("turn-takes"))) at -6,16.4 center tc ls SYMPLECTIC_EULER
plot file("turning") every ::::(farthest + 130) using col("x"):col("y") with lines ls CONTEXT lw 0.35, \
     10*cos(t) - 6, 8*sin(t) with lines ls EXACT, \
     file("turning") every ::farthest::(farthest + 130) using col("x"):col("y") with lines ls SYMPLECTIC_EULER, \
     "+" every 1000 using (0):(0) with points ls CONTEXT pt 7 ps 0.9
