if (NARROW) eval canvas(400, 430)
eval axis_names("time  [s]", "energy over that of the blow")
set logscale y
set xrange [0:1]
set yrange [0.4:25]
set xtics 0.2
if (NARROW) set xtics 0.5
set ytics (0.5, 1, 2, 5, 10, 20)
unset mytics
set rmargin NARROW ? 11 : 24
set label 1 NARROW ? "trapezoid,\none solve" : "trapezoid, one solve" at 1.03,NARROW ? 17 : 14.5 left tc ls TRAPEZOID
set label 2 NARROW ? "backward E.,\none solve" : "backward Euler, one solve" at 1.03,NARROW ? 1.82 : 1.57 left tc ls BACKWARD_EULER
set label 4 NARROW ? "trapezoid,\nto the end" : "trapezoid, to the end" at 1.03,NARROW ? 1.02 : 0.88 left tc ls TRAPEZOID
set label 3 NARROW ? "backward E.,\nto the end" : "backward Euler, to the end" at 1.03,NARROW ? 0.55 : 0.473 left tc ls BACKWARD_EULER
plot file("blow") using col("t"):col("trapezoid") with lines ls TRAPEZOID dt (6,4), \
     file("blow") using col("t"):col("one solve") with lines ls BACKWARD_EULER dt (6,4), \
     file("blow") using col("t"):col("trapezoid end") with lines ls TRAPEZOID dt solid, \
     file("blow") using col("t"):col("to the end") with lines ls BACKWARD_EULER, \
     file("blow") every 6 using col("t"):col("one solve"):(sprintf("one solve, %.2f s: %.2f", val("t"), val("one solve"))) with labels hypertext point ls BACKWARD_EULER ps 0.3, \
     file("blow") every 6 using col("t"):col("to the end"):(sprintf("to the end, %.2f s: %.3f", val("t"), val("to the end"))) with labels hypertext point ls BACKWARD_EULER ps 0.3, \
     file("blow") every 6 using col("t"):col("trapezoid"):(sprintf("trapezoid, one solve, %.2f s: %.2f", val("t"), val("trapezoid"))) with labels hypertext point ls TRAPEZOID pt 7 ps 0.3
