eval NARROW ? canvas(400, 300) : canvas(720, 300)
# Three panels with one pair of axes: the push over the time of one step, and what a method takes for it.
array methods = ["Euler", "midpoint", "RK4"]
array looks = [EULER, MIDPOINT, RK4]
array added = [number("burn-euler"), number("burn-midpoint"), number("burn-rk4")]
wide = 4
apart = NARROW ? 0.7 : 0.9
left(i) = (i - 1)*(wide + apart)
eval axis_names("each of them a step of ".number("burn-step"), "push  [m/s²]")
set xrange [-0.1:left(3) + wide + 0.3]
set yrange [0:29]
set border 2
set ytics 5
unset xtics
set grid noxtics
do for [i=1:3] {
  set label 3*i methods[i] at left(i) + wide/2.,(NARROW ? 28 : 27.6) center tc ls looks[i]
  set label 3*i + 1 added[i] at left(i) + wide/2.,3.2 center tc ls looks[i]
  set arrow i from left(i),0 to left(i) + wide,0 nohead ls CONTEXT lt -1
}
plot for [i=1:3] file("burn-areas") using (left(i) + val("t")):col(methods[i]) with filledcurves y1=0 ls looks[i] fs transparent solid 0.25, \
     for [i=1:3] file("burn-areas") using (left(i) + val("t")):col(methods[i]) with lines ls looks[i] lw 1.6 dt solid, \
     for [i=1:3] file("burn-areas") using (left(i) + val("t")):col("push") with lines ls EXACT dt solid lw 1.8, \
     for [i=1:3] file("burn-areas") every 8 using (left(i) + val("t")):col("push"):(sprintf("after %.1f s: the push is %.1f m/s², %s takes %.1f", val("t"), val("push"), methods[i], val(methods[i]))) with labels hypertext point ls EXACT pt 7 ps 0.2
