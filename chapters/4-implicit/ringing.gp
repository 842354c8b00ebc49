eval axis_names("time  [s]", "stretch of the bar  [mm]")
set xrange [0:1]
set yrange [-1.1:1.25]
set xtics 0.2
set ytics 0.5
set label 1 "trapezoid" at 0.3,0.95 left tc ls TRAPEZOID
set label 2 NARROW ? "backward Euler" : "backward Euler is at rest" at 0.99,-0.9 right tc ls BACKWARD_EULER
set arrow 2 from 0.92,-0.8 to 0.92,-0.05 nohead lc rgb "#000005"
set label 3 "true" at 0.012,1.1 left tc ls EXACT
true(t) = t < 0.11 ? exp(-60*t)*cos(596.99*t) : NaN
set samples 2000
plot true(x) with lines ls EXACT lw 0.8 dt solid, \
     file("ring-trapezoid") using col("t"):(1000*val("x")) with linespoints ls TRAPEZOID lw 1 ps 0.5, \
     file("ring-backward") using col("t"):(1000*val("x")) with linespoints ls BACKWARD_EULER ps 0.4, \
     file("ring-trapezoid") every 3 using col("t"):(1000*val("x")):(sprintf("trapezoid, %.3f s: %.2f mm", val("t"), 1000*val("x"))) with labels hypertext point ls TRAPEZOID ps 0.55
