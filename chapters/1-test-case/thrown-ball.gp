eval axis_names("across  [m]", "height  [m]")
set size ratio -1
set xrange [-0.5:21]
set yrange [-3.5:8]
set xtics 5
set ytics 0,5
set label 1 "no air" at 13,6.6 left tc ls EXACT
set label 2 "in air" at 8.4,1.4 left tc ls EXACT
set label 3 "Euler" at 5.5,6.8 right tc ls EULER
set label 4 "with  {/:Italic a h}^2/2" at 1.6,-1.6 left tc ls CONSTANT_ACCELERATION
set arrow 4 from 4.4,-1.1 to 8.1,-0.6 nohead ls CONTEXT
vacuum = file("throw-in-a-vacuum")
air = file("throw-in-air")
plot vacuum using col("x"):col("y") with lines ls EXACT, \
     air using col("x"):col("y") with lines ls EXACT, \
     vacuum using col("x with a h²/2"):col("y with a h²/2") with points ls CONSTANT_ACCELERATION ps 0.4, \
     vacuum using col("Euler's x"):col("Euler's y") with points ls EULER ps 0.5, \
     air using col("x with a h²/2"):col("y with a h²/2") with points ls CONSTANT_ACCELERATION ps 0.4, \
     air using col("Euler's x"):col("Euler's y") with points ls EULER ps 0.5, \
     vacuum using col("Euler's x"):col("Euler's y"):(sprintf("Euler, no air, after %.2f s: %.2f m too high", val("t"), val("Euler's y") - val("y"))) with labels hypertext point ls EULER ps 0.5, \
     air using col("x with a h²/2"):col("y with a h²/2"):(sprintf("with the term, in air, after %.2f s: %.0f cm off", val("t"), 100 * sqrt((val("x with a h²/2") - val("x"))**2 + (val("y with a h²/2") - val("y"))**2))) with labels hypertext point ls CONSTANT_ACCELERATION ps 0.4
