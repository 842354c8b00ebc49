eval axis_names("time  [s]", "stretch  [cm]")
set xrange [0:1]
set yrange [-11:12.5]
set xtics 0,0.25
set ytics -10,5
set label 1 "midpoint" at 0.99,10.6 right tc ls MIDPOINT
set label 2 "RK4" at NARROW ? 0.38 : 0.39,3.3 left tc ls RK4
set label 3 "true" at 0.345,6.4 left tc ls EXACT
plot file("suspension-midpoint") using col("t"):(100*val("x")) with linespoints ls MIDPOINT lw 1.2, \
     file("suspension-rk4") using col("t"):(100*val("x")) with linespoints ls RK4 lw 1.2, \
     file("suspension-exact") using col("t"):(100*val("x")) with lines ls EXACT, \
     file("suspension-midpoint") using col("t"):(100*val("x")):(sprintf("midpoint at %.2f s: %.2f cm", val("t"), 100*val("x"))) with labels hypertext point ls MIDPOINT, \
     file("suspension-rk4") using col("t"):(100*val("x")):(sprintf("RK4 at %.2f s: %.2f cm", val("t"), 100*val("x"))) with labels hypertext point ls RK4
