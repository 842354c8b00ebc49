eval axis_names("time  [s]", "energy, relative to the throw")
set xrange [0:10]
set yrange [0:2.2]
set xtics 2
set ytics 0.5
set label 1 "turned by its spin at the start" at 6,1.8 center tc ls EULER
set label 2 "Bullet's step" at 6,0.62 center tc ls BACKWARD_EULER
set label 3 "rotations" at 6,1.12 center tc ls VELOCITY_VERLET
plot file("thrown-crate") using col("t"):col("naive") with lines ls EULER, \
     file("thrown-crate") using col("t"):col("bullet") with lines ls BACKWARD_EULER, \
     file("thrown-crate") using col("t"):col("rotations") with lines ls VELOCITY_VERLET
