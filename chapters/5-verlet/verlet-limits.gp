eval axis_names("damping ratio ζ", "longest step times ω")
set xrange [0:2]
set yrange [0:2.15]
set xtics 0.5
set ytics 0.5
set label 1 "position Verlet, leapfrog" at 0.5,1.42 left tc rgb "#000003"
set label 2 "velocity Verlet" at 0.09,0.35 left tc rgb "#000003"
if (NARROW) set label 2 "velocity\nVerlet" at 0.09,0.55
plot 2*(sqrt(1+x*x)-x) with lines ls CONTEXT, \
     2*(sqrt(1+4*x*x)-2*x) with lines ls CONTEXT, \
     file("limits") using 1:2 with points ls STORMER_VERLET, \
     file("limits") using 1:3 with points ls VELOCITY_VERLET, \
     file("limits") using 1:2:(sprintf("zeta %.1f: %.3f", $1, $2)) with labels hypertext point ls STORMER_VERLET, \
     file("limits") using 1:3:(sprintf("zeta %.1f: %.3f", $1, $3)) with labels hypertext point ls VELOCITY_VERLET
