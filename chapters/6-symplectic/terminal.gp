eval axis_names("steps per second", "terminal speed  [m/s]")
set logscale x
set xrange [NARROW ? 1.1 : 3.2:300]
set yrange [3.7:6.2]
set xtics (10, 20, 30, 60, 120, 240)
if (NARROW) set xtics (10, 30, 120)
set ytics 0.5
unset mxtics
set label 1 "implicit first" at 9,5.886 right tc ls THIRD
set label 2 "exponential first" at 9,5.411 right tc ls SECOND
set label 3 "implicit last" at 9,4.99 right tc ls EXACT
set label 4 "explicit first" at 9,4.8 right tc ls EXACT
set label 5 "exponential last" at 9,4.43 right tc ls SECOND
set label 6 "explicit last" at 9,3.924 right tc ls FIRST
array way = ["explicit last", "explicit first", "implicit last", "implicit first", "exponential last", "exponential first"]
array look = [FIRST, EXACT, EXACT, THIRD, SECOND, SECOND]
plot for [n=1:6] file("terminal") using col("steps per second"):col(way[n]) with linespoints ls look[n] dt solid, \
     for [n=1:6] file("terminal") every 3 using col("steps per second"):col(way[n]):(sprintf("%d steps a second: %.3f m/s", val("steps per second"), val(way[n]))) \
       with labels hypertext point ls look[n]
