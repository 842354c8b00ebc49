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
# The table's rows: the four looks, and the end of the step.
x(row) = cell("looks", row, "x")
y(row) = cell("looks", row, "y")
u(row) = 0.3*cell("looks", row, "u")
v(row) = 0.3*cell("looks", row, "v")
set label 1 "1" at 9.7,-0.2 right tc ls RK4
set label 2 "2" at 10.3,3.6 left tc ls RK4
set label 3 "3" at 8.75,3.5 right tc ls RK4
set label 4 "4" at 7.5,6.4 right tc ls RK4
set label 5 NARROW ? "end" : "RK4 ends here" at 6.7,7.5 right tc ls RK4
do for [k=1:4] { set arrow k from x(k),y(k) to x(k) + u(k),y(k) + v(k) ls RK4 lw 1.6 filled size 0.25,20 }
set arrow 5 from x(1),y(1) to x(5),y(5) ls RK4 lw 2.2 filled size 0.25,20
circle = exact("circle")
plot circle*cos(t), circle*sin(t) with lines ls EXACT, \
     "+" every 1000 using (7.0711):(7.0711) with points ls EXACT pt 6 ps 1.2, \
     file("looks") every ::0::3 using col("x"):col("y") with points ls RK4 pt 7 ps 0.7, \
     file("looks") using col("x"):col("y"):(sprintf("%.2f m from the tower", sqrt(val("x")**2 + val("y")**2))) with labels hypertext point ls CONTEXT ps 0.5
