eval axis_names("time  [s]", "height  [m]")
set xrange [0.15:0.95]
set yrange [0.75:1.5]
set xtics 0.2,0.2
set ytics 0.75,0.25
set label 1 "ten games" at 0.56,1.42 center tc rgb "#000001"
plot for [game=1:10] file("uneven") using ($1 == game ? $2 : NaN):3 with linespoints ls EULER lw 0.9 ps 0.3, \
     5*x - 9.81*x**2/2 with lines ls EXACT, \
     for [game=1:10] file("uneven") every 5 using ($1 == game ? $2 : NaN):3:(sprintf("game %d: %.3f m at %.3f s", $1, $3, $2)) \
       with labels hypertext point ls EULER ps 0.3
