eval NARROW ? canvas(400, 460) : canvas(520, 620)
eval axis_names("x  [radii]", "y  [radii]")
set size ratio -1
set xrange [-1.4:1.6]
set yrange [-1.3:3.4]
set xtics 1
set ytics 1
set parametric
set trange [0:2*pi]
set label 1 "2{/:Italic u – u_{prev}}" at 0.9,2.6 right tc ls THIRD
set label 2 "normalised" at 0,-0.6 center tc ls FIRST
plot cos(t), sin(t) with lines ls EXACT, \
     for [i=1:31:6] file("wheel") every ::i::i using (0):(0):col("x"):col("y") with vectors nohead ls GRID lw 1.4, \
     file("wheel") every ::1::31 using col("x"):col("y") with points ls THIRD pt 7 ps 0.6, \
     file("wheel") using col("kept x"):col("kept y") with points ls FIRST ps 0.6
