eval axis_names("time after the blow  [s]", "energy that is left")
set xrange [0:3]
set yrange [0:1.12]
set xtics 1
set ytics 0.25
set label 1 "in substeps" at 1.15,1.07 left tc ls SYMPLECTIC_EULER
set label 2 "BDF2" at 2.08,0.34 left tc ls BDF2
set label 3 "backward Euler" at 0.3,0.06 left tc ls BACKWARD_EULER
plot file("cloths") using col("t"):col("in substeps") with lines ls SYMPLECTIC_EULER, \
     file("cloths") using col("t"):col("BDF2") with lines ls BDF2, \
     file("cloths") using col("t"):col("backward Euler") with lines ls BACKWARD_EULER, \
     file("cloths") every 20 using col("t"):col("in substeps"):(sprintf("in substeps, %.2f s: %.3f", val("t"), val("in substeps"))) with labels hypertext point ls SYMPLECTIC_EULER ps 0.35, \
     file("cloths") every 20 using col("t"):col("BDF2"):(sprintf("BDF2, %.2f s: %.3f", val("t"), val("BDF2"))) with labels hypertext point ls BDF2 ps 0.35, \
     file("cloths") every 20 using col("t"):col("backward Euler"):(sprintf("backward Euler, %.2f s: %.3f", val("t"), val("backward Euler"))) with labels hypertext point ls BACKWARD_EULER ps 0.35
