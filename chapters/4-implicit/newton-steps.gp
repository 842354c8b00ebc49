eval axis_names("iteration", "change of the velocity  [m/s]")
set logscale y
set xrange [0.6:18.6]
set yrange [1e-13:100]
set xtics (1, 5, 10, 15)
set ytics ("10^{−12}" 1e-12, "10^{−9}" 1e-9, "10^{−6}" 1e-6, "10^{−3}" 1e-3, "1" 1)
set lmargin NARROW ? 7.5 : 8
unset mytics
set label 1 "parachute" at 2.6,12 left tc ls FIRST
set label 2 "cloth, hard blow" at 9.6,5e-5 left tc ls THIRD
set label 3 NARROW ? "rope, hard" : "rope, hard blow" at 6.5,4e-13 left tc ls SECOND
set label 4 NARROW ? "gentle" : "rope, gentle blow" at 1,1e-11 left tc ls SECOND
set label 5 "good enough" at 11.5,1.2e-10 center tc ls LIMIT
plot 1e-9 with lines ls LIMIT, \
     file("newton") using col("iteration"):(val("parachute") > 0 ? val("parachute") : NaN) with linespoints ls FIRST, \
     file("newton") using col("iteration"):col("rope, gentle") with linespoints ls SECOND dt (6,4) pt 4 lw 1.8, \
     file("newton") using col("iteration"):col("rope, hard") with linespoints ls SECOND, \
     file("newton") using col("iteration"):col("cloth, hard") with linespoints ls THIRD, \
     file("newton") using col("iteration"):(val("parachute") > 0 ? val("parachute") : NaN):(sprintf("parachute, iteration %d: %.2g m/s", val("iteration"), val("parachute"))) with labels hypertext point ls FIRST, \
     file("newton") using col("iteration"):col("cloth, hard"):(sprintf("cloth, iteration %d: %.2g m/s", val("iteration"), val("cloth, hard"))) with labels hypertext point ls THIRD
