eval axis_names("", "energy after one step, relative to before")
set xlabel "{/:Italic hω}" offset 0,0.3
set xrange [0:3.05]
set yrange [0:2.05]
set xtics 0.5
set ytics 0,0.5
set label 1 "Euler" at 0.78,1.78 right tc ls EULER
set label 2 "midpoint" at 1.46,1.95 left tc ls MIDPOINT
set label 3 "RK4" at 1.86,0.5 right tc ls RK4
set label 4 "√8" at 2.8,0.12 right tc ls LIMIT
set arrow 1 from sqrt(8),1 to sqrt(8),0 nohead ls LIMIT
plot 1 with lines ls EXACT, \
     1 + x**2 with lines ls EULER lw 1.2, \
     1 + x**4/4 with lines ls MIDPOINT lw 1.2, \
     1 - x**6/72 + x**8/576 with lines ls RK4 lw 1.2, \
     file("factors") using col("hω"):col("Euler") with points ls EULER, \
     file("factors") using col("hω"):col("midpoint") with points ls MIDPOINT, \
     file("factors") using col("hω"):col("RK4") with points ls RK4, \
     file("factors") using col("hω"):(val("Euler") < 2.05 ? val("Euler") : NaN):(sprintf("Euler, hω = %.2f: %.4f", val("hω"), val("Euler"))) with labels hypertext point ls EULER, \
     file("factors") using col("hω"):(val("midpoint") < 2.05 ? val("midpoint") : NaN):(sprintf("midpoint, hω = %.2f: %.5f", val("hω"), val("midpoint"))) with labels hypertext point ls MIDPOINT, \
     file("factors") using col("hω"):(val("RK4") < 2.05 ? val("RK4") : NaN):(sprintf("RK4, hω = %.2f: %.8f", val("hω"), val("RK4"))) with labels hypertext point ls RK4
