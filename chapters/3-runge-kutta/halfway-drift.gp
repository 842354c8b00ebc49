eval axis_names("time  [s]", "distance from the tower  [m]")
set xrange [0:80]
set yrange [9.3:15.6]
set xtics 0,16
set ytics 10,1
set label 1 "Euler, ".number("rate") at 66,14.45 right tc ls EULER
set label 2 NARROW ? "looks halfway" : "looks halfway, ".number("rate") at 80,NARROW ? 11 : 11.4 right tc ls MIDPOINT
set label 3 "should stay here" at 40,9.7 center tc ls EXACT
set label 4 "circles: Euler, ".number("rate-twice") at 80,NARROW ? 10.4 : 10.8 right tc ls EULER
plot exact("circle") with lines ls EXACT, \
     file("distance") using col("t"):col("Euler") with lines ls EULER, \
     file("distance") using col("t"):col("old velocity") with lines ls MIDPOINT dt (6,4), \
     file("distance") every (NARROW ? 8 : 4) using col("t"):col("Euler at 120 Hz") with points ls EULER pt 6 ps 0.7, \
     file("distance") every 4 using col("t"):col("Euler"):(sprintf("Euler, after %.0f s: %.2f m", val("t"), val("Euler"))) with labels hypertext point ls EULER ps 0.3, \
     file("distance") every 4 using col("t"):col("old velocity"):(sprintf("after %.0f s: %.4f m; Euler with twice the steps: %.4f m", val("t"), val("old velocity"), val("Euler at 120 Hz"))) with labels hypertext point ls EULER pt 6 ps 0.7
