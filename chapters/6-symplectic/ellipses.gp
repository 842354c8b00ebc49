eval NARROW ? canvas(400, 400) : canvas(560, 560)
eval axis_names("stretch  [cm]", "velocity over ω  [cm]")
set size ratio -1
set xrange [-14:14]
set yrange [-14:14]
set xtics 5
set ytics 5
set parametric
set trange [0:2*pi]
k = 20/30.
far = 10/sqrt(2 - k)
near = 10/sqrt(2 + k)
set label 1 "velocity first" at 4,12.6 left tc ls SYMPLECTIC_EULER
set label 2 "position first" at -4,12.6 right tc ls FIRST
set label 3 "true" at 0,8.4 center tc ls EXACT
plot 10*cos(t), 10*sin(t) with lines ls EXACT, \
     far*cos(t) - near*sin(t), far*cos(t) + near*sin(t) with lines ls SYMPLECTIC_EULER lw 1, \
     near*cos(t) - far*sin(t), near*cos(t) + far*sin(t) with lines ls FIRST lw 1, \
     file("ellipse") using (100*val("x")):(5*val("v")) with points ls SYMPLECTIC_EULER ps 0.5, \
     file("ellipse-twin") using (100*val("x")):(5*val("v")) with points ls FIRST ps 0.55, \
     file("ellipse") every 2 using (100*val("x")):(5*val("v")):(sprintf("at %.2f s: %.1f cm, %.1f m/s", val("t"), 100*val("x"), val("v"))) with labels hypertext point ls SYMPLECTIC_EULER ps 0.5
