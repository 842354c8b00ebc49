eval NARROW ? canvas(400, 400) : canvas(620, 560)
eval axis_names("angle  [rad]", "angular velocity  [rad/s]")
set size ratio -1
set xrange [-0.5:1.6]
set yrange [-1.5:0.5]
set xtics 0.5
set ytics 0.5
set label 1 "start" at 1.32,0.12 left tc ls EXACT
set label 2 "kicked" at 1.34,-1.12 left tc ls FIRST
set label 3 "drifted" at -0.15,-0.42 center tc ls SYMPLECTIC_EULER
set arrow 1 from 0.72,-0.36 to 0.72,-0.68 head size 0.05,20 ls CONTEXT
set arrow 2 from 0.66,-0.95 to 0.4,-0.95 head size 0.05,20 ls CONTEXT
plot file("shears") using col("x"):col("v") with filledcurves closed ls AREA, \
     file("shears") using col("x"):col("kicked v") with filledcurves closed ls AREA, \
     file("shears") using col("drifted x"):col("kicked v") with filledcurves closed ls AREA, \
     file("shears") using col("x"):col("v") with lines ls EXACT dt solid, \
     file("shears") using col("x"):col("kicked v") with lines ls FIRST lw 1.6, \
     file("shears") using col("drifted x"):col("kicked v") with lines ls SYMPLECTIC_EULER lw 1.6
