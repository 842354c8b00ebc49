eval axis_names("damping ratio {/:Italic ζ}", "longest step times {/:Italic ω}")
set xrange [0:2]
set yrange [0:2.15]
set xtics 0.5
set ytics 0.5
set label 1 "position Verlet, leapfrog" at 0.5,1.42 left tc ls LEAPFROG
set label 2 "velocity Verlet" at 0.09,0.35 left tc ls VELOCITY_VERLET
if (NARROW) set label 2 "velocity\nVerlet" at 0.09,0.55
plot 2*(sqrt(1+x*x)-x) with lines ls CONTEXT, \
     2*(sqrt(1+4*x*x)-2*x) with lines ls CONTEXT, \
     file("limits") using col("zeta"):col("position Verlet") with points ls STORMER_VERLET, \
     file("limits") using col("zeta"):col("velocity Verlet") with points ls VELOCITY_VERLET, \
     file("limits") using col("zeta"):col("position Verlet"):(sprintf("zeta %.1f: %.3f", val("zeta"), val("position Verlet"))) with labels hypertext point ls STORMER_VERLET, \
     file("limits") using col("zeta"):col("velocity Verlet"):(sprintf("zeta %.1f: %.3f", val("zeta"), val("velocity Verlet"))) with labels hypertext point ls VELOCITY_VERLET
