eval axis_names("time  [s]", "height  [m]")
set xrange [0.15:0.95]
set yrange [0.75:1.5]
set xtics 0.2,0.2
set ytics 0.75,0.25
array rate = [20, 30, 60, 144]
hertz(i) = sprintf("%d Hz", rate[i])
set label 1 "ledge, ".number("ledge") at 0.94,NARROW ? 1.37 : 1.358 right tc ls LIMIT
set label 2 hertz(1) at 0.52,1.445 center tc ls EULER
set label 3 hertz(4) at 0.52,NARROW ? 1.19 : 1.225 center tc ls EULER
set label 4 hertz(2) at 0.8,1.27 left tc ls EULER
set label 5 hertz(3) at 0.8,1.18 left tc ls EULER
set arrow 4 from 0.795,1.27 to 0.66,1.27 nohead ls CONTEXT
set arrow 5 from 0.795,1.18 to 0.684,1.18 nohead ls CONTEXT
plot exact("ledge") with lines ls LIMIT, \
     5*x - 9.81*x**2/2 with lines ls EXACT, \
     for [i=1:4] file("jump") using (val("rate") == rate[i] ? val("t") : NaN):col("height") with linespoints ls EULER lw 1.4 ps (i == 4 ? 0.3 : 0.6), \
     for [i=1:4] file("jump") using (val("rate") == rate[i] ? val("t") : NaN):col("height"):(sprintf("%s: %.3f m at %.3f s", hertz(i), val("height"), val("t"))) \
       with labels hypertext point ls EULER
