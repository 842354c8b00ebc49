eval NARROW ? canvas(400, 400) : canvas(600, 580)
unset border
unset tics
unset grid
set size ratio -1
set lmargin 0
set rmargin 0
set tmargin 0
set bmargin 0
set xrange [-1.25:1.25]
set yrange [-1.2:1.2]
set parametric
set trange [0:2*pi]
across(piece, side) = txt("piece") eq piece && val("front") == side ? val("x") : NaN
array pieces = ["first", "second", "third"]
array styles = [FIRST, SECOND, THIRD]
array axes = ["axis 1", "axis 2", "axis 3"]
array called = ["long axis", "middle axis", "short axis"]
set label 1 "first" at 0.07,0.6 left front tc ls FIRST
set label 2 "second" at -0.16,0.49 right front tc ls SECOND
set label 3 "third" at -0.19,0.16 right front tc ls THIRD
set label 4 "true" at -0.02,-0.13 left front tc ls EXACT
# A name stands above its dot, and within the ball.
beside(i) = i == 1 ? (NARROW ? 0.2 : 0.14) : 0
above(i) = i == 2 ? 0.12 : 0.08
array over = ["over", "and over"]
plot cos(t), sin(t) with filledcurves closed ls AREA, \
     cos(t), sin(t) with lines ls CONTEXT, \
     for [i=1:3] file("spin-ball") using (across("circle of the ".pieces[i], 1)):col("y") with lines ls CONTEXT lw 0.8, \
     for [i=1:2] file("spin-ball") using (across(over[i], 0)):col("y") with lines ls EXACT lw 0.6 dt (2,4), \
     for [i=1:2] file("spin-ball") using (across(over[i], 1)):col("y") with lines ls EXACT dt solid, \
     for [i=1:3] file("spin-ball") using (across(pieces[i], 1)):col("y") with lines ls styles[i] lw 3.4, \
     for [i=1:3] file("spin-ball") using (across(axes[i], 1)):col("y") with points ls CONTEXT pt 7 ps 0.6, \
     for [i=1:3] file("spin-ball") using (across(axes[i], 1) + beside(i)):(val("y") + above(i)):(called[i]) with labels tc ls CONTEXT, \
     file("spin-ball") using (across("start", 1)):col("y") with points ls EXACT pt 7 ps 0.7, \
     file("spin-ball") using (across("end", 1)):col("y") with points ls THIRD pt 7 ps 0.7, \
     file("spin-ball") using (across("true end", 1)):col("y") with points ls EXACT pt 6 ps 0.8
