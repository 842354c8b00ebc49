eval canvas(300, 220)
unset border
unset tics
set lmargin 0
set rmargin 0
set tmargin 0
set bmargin 0
set size ratio -1
set xrange [-17:7]
set yrange [-10:10]
set label 1 "race" at -4.5,6.6 center tc ls SECOND
set label 9 "" at 0,0 point ls CONTEXT pt 7 ps 1.6
plot file("race-shuttle") using col("x"):col("y") with lines ls SECOND lw 1.4, \
     file("shuttle") using col("x"):col("y") with lines ls FIRST lw 1.4, \
     file("shuttle") every 15::1 using col("x"):col("y") with points ls FIRST ps 0.5
