eval axis_names("time  [s]", "too high by  [cm]")
set xrange [0:NARROW ? 1.2 : 1.13]
set yrange [0:36]
set xtics 0.25
set ytics 10
rate(i) = word("15 30 60", i)
set for [i=1:3] label i rate(i)." Hz" at 1,981/2./rate(i) left offset 0.8,0 tc rgb "#000001"
plot for [i=1:3] x <= 1 ? 981*x/2/rate(i) : NaN with lines ls CONTEXT, \
     for [i=1:3] file("jump") using (abs($1*rate(i) - 1) < 1e-9 ? $2 : NaN):(100*$3) with points ls EULER, \
     for [i=1:3] file("jump") every 2 using (abs($1*rate(i) - 1) < 1e-9 ? $2 : NaN):(100*$3):(sprintf("%s Hz, at %.2f s: %.2f cm", rate(i), $2, 100*$3)) \
       with labels hypertext point ls EULER
