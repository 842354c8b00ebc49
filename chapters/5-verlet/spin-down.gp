eval axis_names("time  [s]", "turns per second")
set xrange [0:10]
set yrange [0:1.15]
set xtics 2
set ytics 0.25
set label 1 "an angle" at 5,1.08 center tc ls VELOCITY_VERLET
set label 2 "a box of four points, eight steps in a frame" at 9.9,0.84 right tc ls SECOND
set label 3 "a normalised direction, and a box" at 2.6,NARROW ? 0.58 : 0.56 left tc ls FIRST
if (NARROW) set label 2 "box, eight steps" ; set label 3 "direction and box"
plot 1 with lines ls STORMER_VERLET, \
     file("spin") using col("t"):col("box in eight") with lines ls SECOND dt (6,4), \
     file("spin") using col("t"):col("direction") with lines ls FIRST, \
     file("spin") every 20 using col("t"):col("box") with points ls SECOND, \
     file("spin") every 60 using col("t"):col("direction"):(sprintf("%.0f s: direction %.3f, box %.3f, box in eight steps %.3f turns a second", val("t"), val("direction"), val("box"), val("box in eight"))) with labels hypertext point ls FIRST ps 0.3
