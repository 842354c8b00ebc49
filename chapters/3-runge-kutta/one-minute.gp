eval axis_names("time  [s]", "energy, relative to the start")
set xrange [0:NARROW ? 75 : 70]
set yrange [0:1.08]
set xtics 0,15,60
set ytics 0,0.25
array swings = [2, 3, 4, 6, 8]
hertz(i) = sprintf("%d Hz", swings[i])
set label 2 hertz(1) at 61,1.04 left tc ls RK4
set label 3 hertz(2) at 61,0.935 left tc ls RK4
set label 4 hertz(3) at 61,0.768 left tc ls RK4
set label 5 hertz(4) at 26,0.33 left tc ls RK4
set label 6 hertz(5) at NARROW ? 12 : 11,0.13 left tc ls RK4
plot 1 with lines ls EXACT, \
     for [i=1:5] file("minute") using col("t"):col(hertz(i)) with lines ls RK4 lw 1.8, \
     for [i=1:5] file("minute") every 12 using col("t"):col(hertz(i)):(sprintf("%d swings a second, after %.0f s: %.4f", swings[i], val("t"), val(hertz(i)))) \
       with labels hypertext point ls RK4 ps 0.4
