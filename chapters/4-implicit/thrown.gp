eval axis_names("time  [s]", "energy of the spin over that of the throw")
set xrange [0:10]
set yrange [0:4]
set xtics 2
set ytics 1
set label 1 "Euler" at 2.75,3.3 left tc rgb "#000001"
set label 2 "backward Euler" at 4.2,0.47 left tc rgb "#000005"
set label 3 "trapezoid" at 7.4,1.17 left tc rgb "#00000b"
set label 4 "true" at 5.2,1.17 left tc rgb "#000007"
plot 1 with lines ls EXACT, \
     file("spin") using 1:($2 < 5 ? $2 : NaN) with lines ls EULER, \
     file("spin") using 1:3 with lines ls BACKWARD_EULER, \
     file("spin") using 1:4 with lines ls TRAPEZOID lw 1.6, \
     file("spin") every 30 using 1:($2 < 5 ? $2 : NaN):(sprintf("Euler, %.1f s: %.2f", $1, $2)) with labels hypertext point ls EULER ps 0.3, \
     file("spin") every 30 using 1:3:(sprintf("backward Euler, %.1f s: %.3f", $1, $3)) with labels hypertext point ls BACKWARD_EULER ps 0.3, \
     file("spin") every 30 using 1:4:(sprintf("trapezoid, %.1f s: %.4f", $1, $4)) with labels hypertext point ls TRAPEZOID ps 0.3
