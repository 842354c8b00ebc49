eval axis_names("time  [s]", "energy, relative to the start")
set logscale y
set xrange [0:NARROW ? 70 : 68]
set yrange [0.9:4.2]
set xtics 0,15,60
set ytics (1, 1.5, 2, 3, 4)
growth(rate, t) = (1 + (2*pi/8/rate)**2)**(rate*t)
rate(i) = word("30 60 120 240", i)
set for [i=1:4] label i rate(i)." Hz" at 60,growth(rate(i) + 0, 60) left offset 0.8,-0.45 tc rgb "#000001"
plot for [i=1:4] growth(rate(i) + 0, x) with lines ls CONTEXT, \
     for [i=1:4] file("energy") using 1:(column(i + 1)) with points ls EULER, \
     for [i=1:4] file("energy") using 1:(column(i + 1)):(sprintf("%s Hz, after %.0f s: %.4f", rate(i), $1, column(i + 1))) \
       with labels hypertext point ls EULER
