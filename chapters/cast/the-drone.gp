eval canvas(300, 250)
unset border
unset tics
set lmargin 0
set rmargin 0
set tmargin 0
set bmargin 0
set size ratio -1
set xrange [-16:16]
set yrange [-13:13]
fence = exact("drone-fence") / exact("drone-radius")
set label 1 "tower" at 0,-2 center
set label 2 "fence" at -10.2,-11.4 center tc ls LIMIT
set label 9 "" at 0,0 point ls CONTEXT pt 9 ps 1.2
plot file("drone") using (fence * val("x")):(fence * val("y")) with lines ls LIMIT, \
     file("drone") using col("x"):col("y") with lines ls CONTEXT, \
     file("drone") every 15::1 using col("x"):col("y") with points ls FIRST ps 0.5, \
     file("drone") every ::1::1 using col("x"):col("y") with points ls FIRST ps 1.1
