eval NARROW ? canvas(400, 380) : canvas(600, 560)
eval axis_names("angle  [rad]", "angular velocity  [rad/s]")
set size ratio -1
set xrange [-1.9:1.5]
set yrange [-1.65:1.55]
set xtics 1
set ytics 1
set label 1 "start" at 1,0.5 center tc ls EXACT
set label 2 "Euler" at NARROW ? -1.5 : -1.2,1.36 center tc ls EULER
set label 3 NARROW ? "symplectic\nEuler" : "symplectic Euler" at -0.45,NARROW ? 0.35 : 0.3 left tc ls SYMPLECTIC_EULER
third = exact("cat-third")
set label 4 sprintf("%g steps", third) at NARROW ? 0.1 : 0.15,-0.5 center tc ls EXACT
set label 5 sprintf("%g", 2*third) at -0.58,-0.35 left tc ls EXACT
set label 6 sprintf("%g", 3*third) at 0.12,0.95 left tc ls EXACT
x(third) = val("third") == third ? val("x") : NaN
plot for [i=0:3] file("cat-symplectic") using (x(i)):col("v") with filledcurves closed ls AREA, \
     for [i=1:3] file("cat-euler") using (x(i)):col("v") with lines ls EULER lw 1.5, \
     for [i=1:3] file("cat-symplectic") using (x(i)):col("v") with lines ls SYMPLECTIC_EULER lw 1.5, \
     file("cat-euler") using (x(0)):col("v") with lines ls EXACT dt solid
