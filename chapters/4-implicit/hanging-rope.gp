eval axis_names("stiffness of each spring  [kN/m]", "multiplications in a frame")
set logscale xy
set xrange [0.1:500]
set yrange [300:70000]
set xtics (0.1, 1, 10, 100)
set ytics (1000, 10000)
set lmargin NARROW ? 7.5 : 8
unset mxtics
unset mytics
set label 1 "in substeps" at NARROW ? 60 : 70,NARROW ? 26000 : 22000 right tc rgb "#000002"
set label 2 "solved" at 0.13,7000 left tc rgb "#000005"
plot file("nail") using ($1/1000):3 with steps ls SYMPLECTIC_EULER, \
     file("nail") using ($1/1000):4 with lines ls BACKWARD_EULER, \
     file("nail") every 8 using ($1/1000):3:(sprintf("%.2g kN/m, %d substeps: %d", $1/1000, $2, $3)) with labels hypertext point ls SYMPLECTIC_EULER ps 0.3, \
     file("nail") every 8 using ($1/1000):4:(sprintf("%.2g kN/m, solved: %d", $1/1000, $4)) with labels hypertext point ls BACKWARD_EULER ps 0.3
