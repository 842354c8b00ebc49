eval axis_names("corrections", "largest stable step,  {/:Italic c h} or {/:Italic hω}")
set xrange [0.4:20.6]
set yrange [0:2.2]
set xtics (1, 5, 10, 15, 20)
set ytics 0.5
set label 1 "Euler's limit on drag" at 20.4,2.09 right tc ls EULER
set label 2 "drag" at 6.4,1.26 left tc ls BACKWARD_EULER
set label 3 "undamped spring" at 11.6,0.8 left tc ls SECOND
plot 2 with lines ls EULER lw 1.4, \
     1 with lines ls CONTEXT, \
     file("corrections") using col("corrections"):col("drag") with linespoints ls PREDICTED_EULER, \
     file("corrections") using col("corrections"):col("undamped spring") with linespoints ls SECOND lw 1.2, \
     file("corrections") using col("corrections"):col("drag"):(sprintf("%d corrections, drag: %.4f", val("corrections"), val("drag"))) with labels hypertext point ls PREDICTED_EULER, \
     file("corrections") using col("corrections"):col("undamped spring"):(sprintf("%d corrections, spring: %.4f", val("corrections"), val("undamped spring"))) with labels hypertext point ls SECOND
