eval axis_names("time  [s]", "falling speed  [m/s]")
set xrange [0:9]
set yrange [-2.2:13]
set xtics 0,3
set ytics 0,5
array ch = [0.5, 1.5, 2.1]
array look = [EULER, EULER, EULER]
falling(i) = sprintf("drag-%.0f", 10*ch[i])
set label 1 sprintf("{/:Italic ch} = %g", ch[1]) at NARROW ? 6.4 : 0.5,NARROW ? 3.2 : 1.7 left tc ls EULER
set label 2 sprintf("%g", ch[2]) at NARROW ? 1.65 : 2.3,NARROW ? 6.9 : 6.3 left tc ls EULER
set label 3 sprintf("%g", ch[3]) at NARROW ? 5.75 : 5.5,NARROW ? 12.2 : 11.6 left tc ls EULER
if (!NARROW) set label 4 "true" at 7.2,4 left tc ls EXACT
plot 4.905*(1 - exp(-2*x)) with lines ls EXACT, \
     file(falling(3)) using col("t"):(-val("v")) with linespoints ls EULER dt (2,3) pt 6 lw 1.6, \
     file(falling(2)) using col("t"):(-val("v")) with linespoints ls EULER dt (6,4) pt 5 lw 1.6, \
     file(falling(1)) using col("t"):(-val("v")) with linespoints ls EULER lw 1.6, \
     for [i=1:3] file(falling(i)) using col("t"):(-val("v")):(sprintf("ch = %g, at %.2f s: %.2f m/s", ch[i], val("t"), -val("v"))) \
       with labels hypertext point ls look[i]
