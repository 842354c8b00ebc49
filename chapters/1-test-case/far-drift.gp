eval axis_names("time  [s]", "drifted  [m]")
set xrange [0:10.4]
set yrange [-0.08:1.3]
set xtics 2
set ytics 0,0.25
array distance = [4000, 1500, 16000]
km(i) = sprintf("%g km", distance[i]/1000.)
set label 1 km(1) at 9.2,1.17 right tc ls FIRST
set label 2 km(2) at 9.9,NARROW ? 0.66 : 0.72 right tc ls SECOND
set label 3 km(3) at 9.9,0.1 right tc ls THIRD
set label 4 "at the origin" at NARROW ? 5.6 : 6.3,NARROW ? 0.33 : 0.46 left tc ls EXACT
plot 0.1*x with lines ls EXACT, \
     for [i=1:3] file("far") using (val("distance") == distance[i] ? val("t") : NaN):col("drifted") with linespoints ls FIRST + i - 1 pi 6 lw 1.8, \
     for [i=1:3] file("far") using (val("distance") == distance[i] && int(val("t")*6 + 0.5) % 6 == 0 ? val("t") : NaN):col("drifted"):(sprintf("%g km out, %.0f s: %.2f m", val("distance")/1000, val("t"), val("drifted"))) \
       with labels hypertext point ls FIRST + i - 1
