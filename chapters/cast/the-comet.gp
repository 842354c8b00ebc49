eval canvas(300, 110)
unset border
unset tics
set lmargin 0
set rmargin 0
set tmargin 0
set bmargin 0
set size ratio -1
set xrange [-205:12]
set yrange [-38:38]
set label 9 "" at 0,0 point ls EXACT pt 7 ps 0.6
plot file("comet") using col("x"):col("y") with lines ls CONTEXT, \
     file("comet") every 12::1 using col("x"):col("y") with points ls FIRST ps 0.5
