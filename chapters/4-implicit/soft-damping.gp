eval axis_names("{/:Italic h}ω asked for", "damping ratio that you get")
set xrange [0:3.05]
set yrange [0:1]
set xtics 0.5
set ytics 0.2
set label 1 "asked for ζ = 0.7" at 1.2,0.95 left tc rgb "#00000c"
set label 2 "0.2" at 1.9,NARROW ? 0.745 : 0.72 center tc rgb "#00000b"
set label 3 "0" at 1.9,NARROW ? 0.49 : 0.5 center tc rgb "#000005"
set label 4 "½ {/:Italic h}ω" at 0.62,0.22 left tc rgb "#000007"
half(x) = x < 0.95 ? x/2 : NaN
plot half(x) with lines ls EXACT, \
     file("soft") using col("hω"):col("asked 0") with linespoints ls BACKWARD_EULER, \
     file("soft") using col("hω"):col("asked 0.2") with linespoints ls SECOND, \
     file("soft") using col("hω"):col("asked 0.7") with linespoints ls THIRD, \
     file("soft") using col("hω"):col("asked 0"):(sprintf("hω = %.1f, asked for 0: %.3f", val("hω"), val("asked 0"))) with labels hypertext point ls BACKWARD_EULER, \
     file("soft") using col("hω"):col("asked 0.2"):(sprintf("hω = %.1f, asked for 0.2: %.3f", val("hω"), val("asked 0.2"))) with labels hypertext point ls SECOND, \
     file("soft") using col("hω"):col("asked 0.7"):(sprintf("hω = %.1f, asked for 0.7: %.3f", val("hω"), val("asked 0.7"))) with labels hypertext point ls THIRD
