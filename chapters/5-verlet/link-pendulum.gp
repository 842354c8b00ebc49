eval axis_names("time  [s]", "height of the weight  [m]")
set xrange [0:10]
set yrange [-2.5:0.45]
set xtics 2
set ytics 1
set label 1 "one step in a frame" at 9.9,-2.2 right tc ls THIRD
set label 2 "eight steps in a frame" at 9.9,0.2 right tc ls FIRST
plot 0 with lines ls EXACT, \
     file("pendulum") using col("t"):col("eight") with lines ls FIRST lw 1.4, \
     file("pendulum") using col("t"):col("one step") with lines ls THIRD dt solid lw 2, \
     file("pendulum") every 15 using col("t"):col("one step"):(sprintf("%.2f s: one step %.2f m, eight %.2f m", val("t"), val("one step"), val("eight"))) with labels hypertext point ls THIRD ps 0.3
