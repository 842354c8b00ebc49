eval axis_names("time  [s]", "too high by  [cm]")
set xrange [0:NARROW ? 1.2 : 1.13]
set yrange [0:36]
set xtics 0.25
set ytics 10
array rate = [15, 30, 60]
hertz(i) = sprintf("%d Hz", rate[i])
set for [i=1:3] label i hertz(i) at 1,981/2./rate[i] left offset 0.8,0 tc ls EULER
plot for [i=1:3] x <= 1 ? 981*x/2/rate[i] : NaN with lines ls CONTEXT, \
     for [i=1:3] file("jump") using (abs(val("h")*rate[i] - 1) < 1e-9 ? val("t") : NaN):(100*val("error")) with points ls EULER, \
     for [i=1:3] file("jump") every 2 using (abs(val("h")*rate[i] - 1) < 1e-9 ? val("t") : NaN):(100*val("error")):(sprintf("%s, at %.2f s: %.2f cm", hertz(i), val("t"), 100*val("error"))) \
       with labels hypertext point ls EULER
