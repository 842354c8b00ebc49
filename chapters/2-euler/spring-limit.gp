eval axis_names("damping ratio  {/:Italic ζ}", "largest stable step, {/:Italic hω}")
set xlabel "damping ratio  {/:Italic ζ}"
set xrange [0:3.1]
set yrange [0:2.2]
set xtics 0.5
set ytics 0.5
limit(z) = z <= 1 ? 2*z : 2*(z - sqrt(z*z - 1))
set label 1 "explodes" at 2,1.6 center tc ls LIMIT
set label 2 "dies away" at 0.92,0.3 center front tc ls EULER
set label 3 "2ζ" at NARROW ? 0.33 : 0.4,1.08 center tc ls EXACT
set label 4 "2(ζ − √(ζ² − 1))" at 1.45,1 left tc ls EXACT
plot limit(x) with filledcurves x1 ls AREA, \
     limit(x) with lines ls CONTEXT, \
     file("limits") using col("zeta"):col("limit") with points ls EULER, \
     file("limits") using col("zeta"):col("limit"):(sprintf("ζ = %.1f: measured limit %.4f", val("zeta"), val("limit"))) with labels hypertext point ls EULER
