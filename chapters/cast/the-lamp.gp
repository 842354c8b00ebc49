eval canvas(300, 190)
unset border
unset tics
set lmargin 0
set rmargin 0
set tmargin 0
set bmargin 0
set size ratio -1
set xrange [-1.5:1.5]
set yrange [-1.3:0.25]
set label 9 "" at 0,0 point ls CONTEXT pt 5 ps 0.9
plot file("lamp") using (0):(0):col("x"):col("y") with vectors nohead ls CONTEXT, \
     file("lamp") using col("x"):col("y") with points ls FIRST ps 1.2
