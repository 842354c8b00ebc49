eval NARROW ? canvas(400, 390) : canvas(620, 540)
eval axis_names("x  [m]", "y  [m]")
set size ratio -1
set xrange [NARROW ? 1 : 3:13]
set yrange [-0.6:9]
set xtics 2
set ytics 2
set parametric
set trange [-0.2:1.4]
unset grid
set label 1 "start" at 10.3,-0.1 left tc ls EXACT
set label 2 NARROW ? "Euler" : "Euler ends here" at 10.3,7.7 left tc ls EULER
set label 3 NARROW ? "backward" : "backward Euler ends here" at 5.9,NARROW ? 4.7 : 4.5 right tc ls BACKWARD_EULER
if (!NARROW) set label 3 "backward Euler\nends here" at 5.8,4.9 right tc ls BACKWARD_EULER
set label 4 "truth" at 7.4,7.35 left tc ls EXACT
set label 5 NARROW ? "velocity" : "its velocity" at 4.85,7.0 left tc ls BACKWARD_EULER
if (NARROW) set label 5 "velocity" at 3.9,8.4 right tc ls BACKWARD_EULER
# The table's rows: the start, and the end of backward Euler.
x(row) = cell("ends", row, "x")
y(row) = cell("ends", row, "y")
inner = sqrt(x(2)**2 + y(2)**2)
set arrow 1 from x(1),y(1) to x(1),exact("tangent") ls EULER lw 1.6 filled size 0.25,20
set arrow 2 from x(1),y(1) to x(2),y(2) ls BACKWARD_EULER lw 2.2 filled size 0.25,20
set arrow 3 from x(2),y(2) to x(2) + 0.6*(x(2) - x(1)),y(2) + 0.6*(y(2) - y(1)) ls BACKWARD_EULER lw 1.4 dt (4,3) filled size 0.25,20
circle = x(1)
plot circle*cos(t), circle*sin(t) with lines ls EXACT, \
     inner*cos(t), inner*sin(t) with lines ls CONTEXT, \
     "+" every 1000 using (10):(0) with points ls CONTEXT pt 7 ps 0.9, \
     "+" every 1000 using (7.0711):(7.0711) with points ls EXACT pt 7 ps 0.8, \
     file("ends") every ::2::2 using col("x"):col("y") with points ls BACKWARD_EULER ps 0.9, \
     file("ends") using col("x"):col("y"):(sprintf("%.2f m from the tower", sqrt(val("x")**2 + val("y")**2))) with labels hypertext point ls CONTEXT ps 0.5
