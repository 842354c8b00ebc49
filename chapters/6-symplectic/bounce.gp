eval axis_names("time  [s]", "height  [m]")
set xrange [0:8]
set yrange [0:3.3]
set xtics 2
set ytics 1
set label 1 "Euler" at 1.2,3 center tc rgb "#000001"
set label 2 "exact step" at NARROW ? 3.2 : 3.6,3 center tc rgb "#000007"
set label 3 "symplectic Euler" at NARROW ? 6.4 : 6.5,3 center tc rgb "#000002"
plot file("bounce-exact") using 1:2 with lines ls EXACT, \
     file("bounce-euler") using 1:2 with lines ls EULER lw 1.6, \
     file("bounce-symplectic") using 1:2 with lines ls SYMPLECTIC_EULER lw 1.6
