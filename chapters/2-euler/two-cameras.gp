eval axis_names("time since the target jumped  [s]", "distance that is left  [m]")
set xrange [0:0.5]
set yrange [0:10.5]
set xtics 0.1
set ytics 5
array rates = [30, 60, 144]
array lines = [FIRST, SECOND, THIRD]
set label 1 sprintf("lerp at %d Hz", rates[1]) at 0.25,5 left tc ls FIRST
set label 2 sprintf("at %d Hz", rates[2]) at 0.25,2.7 left tc ls SECOND
set label 3 sprintf("at %d Hz", rates[3]) at 0.1,1 right tc ls THIRD
of(i, name) = val("rate") == rates[i] ? val(name) : NaN
# Where symbols would hide each other one in six is drawn.
seldom(i) = i < 3 || int(nearest(val("t")*rates[3]))%6 == 0 ? of(i, "exact") : NaN
nearest(x) = floor(x + 0.5)
plot for [i=1:3] file("machines") using col("t"):(of(i, "lerp")) with linespoints ls lines[i] lw 1.4, \
     file("machines") using col("t"):(seldom(1)) with points ls FIRST pt 6 lw 1.6 ps 1.1, \
     file("machines") using col("t"):(seldom(3)) with points ls THIRD pt 8 lw 1.6 ps 1.2, \
     for [i=1:3] file("machines") using col("t"):(of(i, "lerp")):(sprintf("lerp at %d Hz, after %.3f s: %.2f m", rates[i], val("t"), val("lerp"))) with labels hypertext point ls lines[i]
