eval canvas(300, 190)
unset border
unset tics
set lmargin 0
set rmargin 0
set tmargin 0
set bmargin 0
set size ratio -1
set xrange [-14.715:14.715]
set yrange [-12.753:2.4525]
set label 9 "" at 0,0 point ls CONTEXT pt 5 ps 0.9
plot file("wrecking-ball") using (0):(0):col("x"):col("y") with vectors nohead ls CONTEXT, \
     file("wrecking-ball") using col("x"):col("y") with points ls FIRST ps 1.2
