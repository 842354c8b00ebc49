eval axis_names("time  [s]", "energy over that of the blow")
set logscale y
set xrange [0:1]
set yrange [0.4:2]
set xtics 0.2
if (NARROW) set xtics 0.5
set ytics (0.5, 1, 2)
unset mytics
set rmargin NARROW ? 9 : 14
end(name) = cell("blow", 61, name)
set label 1 "one solve" at 1.03,end("one solve") left tc ls BACKWARD_EULER
set label 2 "two solves" at 1.03,end("two solves") left offset 0,0.7 tc ls BACKWARD_EULER
set label 3 "to the end" at 1.03,end("to the end") left offset 0,-0.6 tc ls BACKWARD_EULER
plot file("blow") using col("t"):col("one solve") with lines ls BACKWARD_EULER dt (6,4), \
     file("blow") using col("t"):col("two solves") with lines ls BACKWARD_EULER dt (2,3), \
     file("blow") using col("t"):col("to the end") with lines ls BACKWARD_EULER, \
     file("blow") every 6 using col("t"):col("one solve"):(sprintf("one solve, %.2f s: %.2f", val("t"), val("one solve"))) with labels hypertext point ls BACKWARD_EULER ps 0.3, \
     file("blow") every 6 using col("t"):col("two solves"):(sprintf("two solves, %.2f s: %.3f", val("t"), val("two solves"))) with labels hypertext point ls BACKWARD_EULER ps 0.3, \
     file("blow") every 6 using col("t"):col("to the end"):(sprintf("to the end, %.2f s: %.3f", val("t"), val("to the end"))) with labels hypertext point ls BACKWARD_EULER ps 0.3
