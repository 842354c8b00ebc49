eval axis_names("time  [s]", "energy that is left")
set xrange [0:1]
set yrange [0:1.04]
set xtics 0.2
set ytics 0.25
set label 1 "spring, one swing a second" at 0.3,0.9 left tc rgb "#000005"
set label 2 "rope" at 0.75,0.74 left tc rgb "#00000b"
set label 3 "cloth" at 0.45,0.165 left tc rgb "#00000c"
set label 4 "chain" at 0.3,0.045 left tc rgb "#00000a"
plot file("second") using 1:5 with lines ls BACKWARD_EULER, \
     file("second") using 1:2 with linespoints ls FIRST ps 0.35, \
     file("second") using 1:3 with linespoints ls SECOND ps 0.35, \
     file("second") using 1:4 with linespoints ls THIRD ps 0.4, \
     file("second") every 6 using 1:2:(sprintf("chain, %.2f s: %.2g", $1, $2)) with labels hypertext point ls FIRST ps 0.35, \
     file("second") every 6 using 1:3:(sprintf("rope, %.2f s: %.3f", $1, $3)) with labels hypertext point ls SECOND ps 0.35, \
     file("second") every 6 using 1:4:(sprintf("cloth, %.2f s: %.3f", $1, $4)) with labels hypertext point ls THIRD ps 0.4
