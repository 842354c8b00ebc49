eval NARROW ? canvas(400, 430) : canvas(560, 600)
eval axis_names("x  [m]", "y  [m]")
set size ratio -1
set xrange [-19:8]
set yrange [-12:18]
set xtics 10
set ytics 10
set parametric
set trange [0:2*pi]
set label 1 "first turn" at -6,-6.2 center tc rgb "#000007"
set label 2 "after 60 turns" at -6,16.4 center tc rgb "#000002"
turn(n) = 120*n
plot file("turning") using 2:3 with lines ls CONTEXT lw 0.35, \
     10*cos(t) - 6, 8*sin(t) with lines ls EXACT, \
     file("turning") every ::turn(60)::(turn(61) + 9) using 2:3 with lines ls SYMPLECTIC_EULER, \
     "+" every 1000 using (0):(0) with points ls CONTEXT pt 7 ps 0.9
