eval axis_names("time  [s]", "energy, relative to the start")
set logscale y
set xrange [0:NARROW ? 70 : 68]
set yrange [0.9:4.2]
set xtics 0,15,60
set ytics (1, 1.5, 2, 3, 4)
growth(rate, t) = (1 + (2*pi/8/rate)**2)**(rate*t)
array rate = [30, 60, 120, 240]
hertz(i) = sprintf("%d Hz", rate[i])
set for [i=1:4] label i hertz(i) at 60,growth(rate[i], 60) left offset 0.8,-0.45 tc ls EULER
plot for [i=1:4] growth(rate[i], x) with lines ls CONTEXT, \
     for [i=1:4] file("energy") using col("t"):col(hertz(i)) with points ls EULER, \
     for [i=1:4] file("energy") using col("t"):col(hertz(i)):(sprintf("%s, after %.0f s: %.4f", hertz(i), val("t"), val(hertz(i)))) \
       with labels hypertext point ls EULER
