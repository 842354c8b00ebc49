eval NARROW ? canvas(400, 400) : canvas(560, 560)
eval axis_names("stretch  [m]", "velocity over ω  [m]")
set size ratio -1
set xrange [-0.5:0.5]
set yrange [-0.5:0.5]
set xtics 0.25
set ytics 0.25
set parametric
set trange [0:2*pi]
# The shadow ellipse x^2 - k x u + u^2 = x0^2, k = h omega, along its two axes; a hyperbola from k = 2 on.
far(k) = 0.1/sqrt(2 - k)
near(k) = 0.1/sqrt(2 + k)
array k = [0.67, 1.5, 1.9, 2.1]
swing(i) = sprintf("opening-%.0f", 100*k[i])
homega(i) = sprintf("%g", k[i])
set label 1 "{/:Italic hω} = ".homega(1) at -0.07,0.19 right tc ls SYMPLECTIC_EULER
set label 2 homega(2) at 0.26,-0.05 left tc ls SYMPLECTIC_EULER
set arrow 1 from 0.25,-0.03 to 0.155,0.095 nohead ls CONTEXT
set label 3 homega(3) at 0.32,0.13 left tc ls SYMPLECTIC_EULER
set label 4 homega(4) at 0.23,0.44 right tc ls LIMIT
along(t) = (t/pi - 1)/2
bend(p) = near(k[4])*sqrt(1 + 10*p*p)
plot for [i=1:3] far(k[i])*cos(t) - near(k[i])*sin(t), far(k[i])*cos(t) + near(k[i])*sin(t) with lines ls CONTEXT, \
     for [side in "1 -1"] along(t) + side*bend(along(t)), along(t) - side*bend(along(t)) with lines ls LIMIT, \
     for [i=1:3] file(swing(i)) using col("x"):(val("v")/20) with points ls SYMPLECTIC_EULER ps 0.35, \
     file(swing(4)) using (abs(val("x")) < 0.6 ? val("x") : NaN):(val("v")/20) with points ls LIMIT pt 7 ps 0.7
