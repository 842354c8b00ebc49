eval NARROW ? canvas(400, 420) : canvas(600, 560)
eval axis_names("x  [m]", "y  [m]")
set size ratio -1
set xrange [-1.0:1.5]
set yrange [-2.6:0.2]
set xtics 1
set ytics 1
array iterations = [1, 4, 64]
set label 1 sprintf("%d iteration", iterations[1]) at 0.5,-1.2 left tc ls THIRD
set label 2 sprintf("%d", iterations[2]) at 0.48,-2.35 left tc ls SECOND
set label 3 sprintf("%d", iterations[3]) at -0.1,-1.3 right tc ls FIRST
set parametric
set trange [0:2*pi]
plot file("shapes") using (val("iterations") == iterations[1] ? val("x") : NaN):col("y") with linespoints ls THIRD lw 1.4, \
     file("shapes") using (val("iterations") == iterations[2] ? val("x") : NaN):col("y") with linespoints ls SECOND lw 1.4, \
     file("shapes") using (val("iterations") == iterations[3] ? val("x") : NaN):col("y") with linespoints ls FIRST lw 1.4, \
     2*cos(t), 2*sin(t) with lines ls EXACT
