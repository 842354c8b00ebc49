eval axis_names("", "largest stable step, {/:Italic hω}")
set xlabel "damping ratio  {/:Italic ζ}" offset 0,0.3
set xrange [0:3.1]
set yrange [0:3.3]
set xtics 0.5
set ytics 1
set label 1 "RK4" at 1.15,2.6 left tc ls RK4
set label 2 "midpoint" at 0.36,2.27 center tc ls MIDPOINT
set label 3 "Euler" at 0.42,0.5 left tc ls EULER
set label 4 "past ζ = 1 the fast rate decides" at 1.35,1.75 left tc ls EXACT
if (NARROW) unset label 4
plot file("limit-lines") using col("ζ"):col("RK4") with lines ls RK4 lw 1.2, \
     file("limit-lines") using col("ζ"):col("midpoint") with lines ls MIDPOINT lw 1.2, \
     file("limit-lines") using col("ζ"):col("Euler") with lines ls EULER lw 1.2, \
     file("limits") using col("ζ"):col("RK4") with points ls RK4, \
     file("limits") using col("ζ"):col("midpoint") with points ls MIDPOINT, \
     file("limits") using col("ζ"):col("Euler") with points ls EULER ps 0.4, \
     file("limits") using col("ζ"):col("RK4"):(sprintf("RK4, ζ = %.1f: %.4f", val("ζ"), val("RK4"))) with labels hypertext point ls RK4, \
     file("limits") using col("ζ"):col("midpoint"):(sprintf("midpoint, ζ = %.1f: %.4f", val("ζ"), val("midpoint"))) with labels hypertext point ls MIDPOINT, \
     file("limits") using col("ζ"):col("Euler"):(sprintf("Euler, ζ = %.1f: %.4f", val("ζ"), val("Euler"))) with labels hypertext point ls EULER ps 0.4
