eval NARROW ? canvas(400, 400) : canvas(560, 560)
eval axis_names("x  [m]", "y  [m]")
set size ratio -1
set xrange [-15.5:15.5]
set yrange [-15.5:15.5]
set xtics 10
set ytics 10
set parametric
set trange [0:2*pi]
set label 1 "RK4" at -5,-4.2 center tc ls RK4
set label 2 "midpoint" at -9,-11.8 right tc ls MIDPOINT
set label 3 "start" at 9.1,1.2 right tc ls EXACT
set label 2 "midpoint" at -8.2,-13 center
circle = exact("circle")
plot circle*cos(t), circle*sin(t) with lines ls EXACT, \
     file("eight-midpoint") using col("x"):col("y") with linespoints ls MIDPOINT lw 1.4, \
     file("eight-rk4") using col("x"):col("y") with linespoints ls RK4 lw 1.4, \
     "+" every 1000 using (0):(0) with points ls CONTEXT pt 7 ps 0.8, \
     file("eight-midpoint") using col("x"):col("y"):(sprintf("midpoint after %.0f s: %.2f m from the tower", val("t"), sqrt(val("x")**2 + val("y")**2))) with labels hypertext point ls MIDPOINT, \
     file("eight-rk4") using col("x"):col("y"):(sprintf("RK4 after %.0f s: %.3f m from the tower", val("t"), sqrt(val("x")**2 + val("y")**2))) with labels hypertext point ls RK4
