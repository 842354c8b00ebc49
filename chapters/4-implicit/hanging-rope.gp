eval axis_names("stiffness of each spring  [kN/m]", "multiplications in a frame")
set logscale xy
set xrange [0.1:500]
set yrange [300:70000]
set xtics (0.1, 1, 10, 100)
set ytics (1000, 10000)
set lmargin NARROW ? 7.5 : 8
unset mxtics
unset mytics
set label 1 "in substeps" at NARROW ? 60 : 70,NARROW ? 26000 : 22000 right tc ls SYMPLECTIC_EULER
set label 2 "solved" at 0.13,7000 left tc ls BACKWARD_EULER
plot file("nail") using (val("stiffness")/1000):col("all substeps") with steps ls SYMPLECTIC_EULER, \
     file("nail") using (val("stiffness")/1000):col("solving") with lines ls BACKWARD_EULER, \
     file("nail") every 8 using (val("stiffness")/1000):col("all substeps"):(sprintf("%.2g kN/m, %d substeps: %d", val("stiffness")/1000, val("substeps"), val("all substeps"))) with labels hypertext point ls SYMPLECTIC_EULER ps 0.3, \
     file("nail") every 8 using (val("stiffness")/1000):col("solving"):(sprintf("%.2g kN/m, solved: %d", val("stiffness")/1000, val("solving"))) with labels hypertext point ls BACKWARD_EULER ps 0.3
