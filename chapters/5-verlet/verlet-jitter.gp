eval axis_names("time  [s]", "height  [m]")
set xrange [0:1.05]
set yrange [0:2.15]
set xtics 0.25
set ytics 0.5
late = cell("late-frame", 1, "jump")
set label 1 (NARROW ? "" : "a frame of ").number("late-frame") at cell("late-frame", 2, "t") + 0.02,cell("late-frame", 2, "x") - 0.12 left tc ls THIRD
set label 2 "ten jumps" at 1.04,1.8 right tc ls CONTEXT
set label 3 "corrected" at 0.5,NARROW ? 1.06 : 1.12 center tc ls VELOCITY_VERLET
plot for [jump=1:10] file("jitter") using (val("jump") == jump ? val("t") : NaN):col("plain") with linespoints ls CONTEXT dt solid lw 0.9 ps 0.3, \
     file("jitter") using (val("jump") == late ? val("t") : NaN):col("plain") with linespoints ls THIRD dt solid ps 0.4, \
     for [jump=1:10] file("jitter-corrected") every 10::jump using (val("jump") == jump ? val("t") : NaN):col("x") with points ls VELOCITY_VERLET ps 0.6, \
     5*x - 9.81*x**2/2 with lines ls EXACT, \
     for [jump=1:10] file("jitter") every 7 using (val("jump") == jump ? val("t") : NaN):col("plain"):(sprintf("jump %d: %.3f m at %.3f s", val("jump"), val("plain"), val("t"))) \
       with labels hypertext point ls CONTEXT ps 0.3
