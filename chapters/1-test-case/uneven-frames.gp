eval axis_names("time  [s]", "height  [m]")
set xrange [0:0.75]
set yrange [0:1.5]
set xtics 0,0.2
set ytics 0,0.5
set label 1 "three: late on the way up" at 0.53,1.44 center tc ls EULER
set label 2 "ledge" at 0.02,1.37 left tc ls LIMIT
set label 3 "seven: not" at 0.53,NARROW ? 1.1 : 1.16 center tc ls CONTEXT
array look[10]
do for [jump=1:10] { look[jump] = cell("uneven-tops", jump, "top") > exact("ledge") ? EULER : CONTEXT }
plot exact("ledge") with lines ls LIMIT, \
     for [jump=1:10] file("uneven") using (val("jump") == jump ? val("t") : NaN):col("height") with linespoints ls look[jump] lw 0.9 ps 0.4, \
     5*x - 9.81*x**2/2 with lines ls EXACT, \
     for [jump=1:10] file("uneven") every 5 using (val("jump") == jump ? val("t") : NaN):col("height"):(sprintf("jump %d: %.3f m at %.3f s", val("jump"), val("height"), val("t"))) \
       with labels hypertext point ls look[jump] ps 0.4
