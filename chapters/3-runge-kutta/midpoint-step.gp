eval NARROW ? canvas(400, 390) : canvas(620, 540)
eval axis_names("x  [m]", "y  [m]")
set size ratio -1
set xrange [3:13]
set yrange [-0.6:9]
set xtics 2
set ytics 2
set parametric
set trange [-0.2:1.4]
unset grid
set label 1 "start" at 9.7,-0.2 right tc ls EXACT
set label 2 "half a step" at 10.3,3.65 left tc ls EULER
set label 3 NARROW ? "Euler" : "Euler ends here" at 10.3,7.7 left tc ls EULER
set label 4 NARROW ? "midpoint" : "midpoint ends here" at 6.9,8.4 left tc ls MIDPOINT
set label 5 "should be here" at 6.6,6.7 right tc ls EXACT
if (NARROW) set label 5 "truth" at 6.6,6.9 right
set label 6 NARROW ? "velocity" : "the velocity there" at 10.3,4.35 left tc ls MIDPOINT
# The table's rows: the start, half a step of Euler, a step of midpoint and one of Euler.
x(row) = cell("middle", row, "x")
y(row) = cell("middle", row, "y")
u = 0.3*cell("middle", 2, "u")
v = 0.3*cell("middle", 2, "v")
set arrow 1 from x(1),y(1) to x(4),y(4) ls EULER lw 1.6 filled size 0.25,20
set arrow 2 from x(2),y(2) to x(2) + u,y(2) + v ls MIDPOINT lw 1.6 filled size 0.25,20
set arrow 3 from x(1),y(1) to x(3),y(3) ls MIDPOINT lw 2.2 filled size 0.25,20
circle = exact("circle")
plot circle*cos(t), circle*sin(t) with lines ls EXACT, \
     file("middle") every ::2::2 using col("x"):col("y") with points ls EULER ps 0.9, \
     "+" every 1000 using (10):(0) with points ls CONTEXT pt 7 ps 0.9, \
     "+" every 1000 using (7.0711):(7.0711) with points ls EXACT pt 7 ps 0.8, \
     file("middle") every ::2::4 using col("x"):col("y"):(sprintf("%.2f m from the tower", sqrt(val("x")**2 + val("y")**2))) with labels hypertext point ls CONTEXT ps 0.5
