eval axis_names("time, in steps", "slope, relative to the first")
set xrange [-0.05:1.15]
set yrange [0:1.12]
set xtics 0,0.5
set ytics 0,0.25
set label 1 "first" at 0.03,1.03 left tc ls RK4
set label 2 "second" at 0.47,0.455 right tc ls RK4
set label 3 "third" at 0.53,0.8 left tc ls RK4
set label 4 "fourth" at 0.97,0.2 right tc ls RK4
set label 5 "true slope" at NARROW ? 0.79 : 0.72,NARROW ? 0.51 : 0.53 left tc ls EXACT
set label 6 "mean of the two" at 0.53,0.64 left tc ls RK4
set arrow 1 from 0.5,0.5 to 0.5,0.75 nohead ls CONTEXT
plot x >= 0 && x <= 1 ? exp(-x) : NaN with lines ls EXACT, \
     file("slopes") using col("t"):col("braking") with points ls RK4 ps 1.1, \
     "+" every 1000 using (0.5):(0.625) with points ls RK4 pt 12 ps 1.1, \
     file("slopes") using col("t"):col("braking"):(sprintf("slope %.3f; true: %.3f", val("braking"), exp(-val("t")))) with labels hypertext point ls RK4 ps 1.1
