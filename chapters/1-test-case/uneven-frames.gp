eval axis_names("time  [s]", "above the true jump  [cm]")
set xrange [0:0.62]
set yrange [0:9]
set xtics 0,0.2
set ytics 0,3
jump(t) = 5*t - 9.81*t**2/2
set label 1 "three: late on the way up" at NARROW ? 0.02 : 0.16,NARROW ? 7.1 : 6.6 left tc ls EULER
set label 2 "ledge" at 0.42,8.4 right tc ls LIMIT
set label 3 "seven: not" at 0.4,NARROW ? 1.6 : 2 left tc ls CONTEXT
array look[10]
do for [n=1:10] { look[n] = cell("uneven-tops", n, "top") > exact("ledge") ? EULER : CONTEXT }
plot 100*(exact("ledge") - jump(x)) with lines ls LIMIT, \
     for [n=1:10] file("uneven") using (val("jump") == n ? val("t") : NaN):(100*(val("height") - jump(val("t")))) with linespoints ls look[n] lw 0.9 ps 0.4, \
     for [n=1:10] file("uneven") every 5 using (val("jump") == n ? val("t") : NaN):(100*(val("height") - jump(val("t")))):(sprintf("jump %d: %.3f m at %.3f s", val("jump"), val("height"), val("t"))) \
       with labels hypertext point ls look[n] ps 0.4
