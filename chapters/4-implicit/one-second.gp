eval axis_names("time  [s]", "energy that is left")
set xrange [0:1]
set yrange [0:1.04]
set xtics 0.2
set ytics 0.25
set label 1 "spring, one swing a second" at 0.3,0.9 left tc ls BACKWARD_EULER
set label 2 "rope" at 0.2,0.36 left tc ls SECOND
set label 3 "cloth" at 0.75,0.06 left tc ls THIRD
set label 4 "chain" at 0.3,0.045 left tc ls FIRST
plot file("second") using col("t"):col("1 Hz") with lines ls BACKWARD_EULER, \
     file("second") using col("t"):col("chain") with linespoints ls FIRST ps 0.35, \
     file("second") using col("t"):col("rope") with linespoints ls SECOND ps 0.35, \
     file("second") using col("t"):col("cloth") with linespoints ls THIRD ps 0.4, \
     file("second") every 6 using col("t"):col("chain"):(sprintf("chain, %.2f s: %.2g", val("t"), val("chain"))) with labels hypertext point ls FIRST ps 0.35, \
     file("second") every 6 using col("t"):col("rope"):(sprintf("rope, %.2f s: %.3f", val("t"), val("rope"))) with labels hypertext point ls SECOND ps 0.35, \
     file("second") every 6 using col("t"):col("cloth"):(sprintf("cloth, %.2f s: %.3f", val("t"), val("cloth"))) with labels hypertext point ls THIRD ps 0.4
