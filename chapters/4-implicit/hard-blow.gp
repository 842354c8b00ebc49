eval axis_names("time  [s]", "energy over that of the blow")
set logscale y
set xrange [0:1]
set yrange [0.3:30]
set xtics 0.2
set ytics (0.5, 1, 2, 5, 10, 20)
unset mytics
set label 1 "trapezoid, one solve" at 0.98,5.4 right tc rgb "#000005"
set label 2 NARROW ? "one solve" : "backward Euler, one solve" at 0.98,1.83 right tc rgb "#000005"
set label 3 NARROW ? "to the end" : "backward Euler, to the end" at 0.98,0.55 right tc rgb "#00000a"
set label 4 "trapezoid, to the end" at 0.98,1.08 right tc rgb "#00000b"
plot file("blow") using 1:4 with lines ls TRAPEZOID, \
     file("blow") using 1:2 with lines ls BACKWARD_EULER, \
     file("blow") using 1:5 with lines ls SECOND lw 1.4, \
     file("blow") using 1:3 with lines ls FIRST, \
     file("blow") every 6 using 1:2:(sprintf("one solve, %.2f s: %.2f", $1, $2)) with labels hypertext point ls BACKWARD_EULER ps 0.3, \
     file("blow") every 6 using 1:3:(sprintf("to the end, %.2f s: %.3f", $1, $3)) with labels hypertext point ls FIRST ps 0.3, \
     file("blow") every 6 using 1:4:(sprintf("trapezoid, one solve, %.2f s: %.2f", $1, $4)) with labels hypertext point ls TRAPEZOID ps 0.3
