eval axis_names("frame", "length of the rope  [m]")
set logscale y
set xrange [0:9]
set yrange [1:1e10]
set xtics 1
set ytics ("1 m" 1, "1 km" 1e3, "10^3 km" 1e6, "10^6 km" 1e9)
unset mytics
set lmargin 8.5
rate(name) = NARROW ? number(name) : sprintf("%g steps a second", exact(name))
set label 1 "springs, ".rate("burst-rate") at 5.7,1e6 right tc ls FIRST
set label 2 "springs, ".rate("calm-rate") at 8.9,NARROW ? 90 : 80 right tc ls SECOND
set label 3 "links, ".rate("burst-rate") at 8.9,NARROW ? 12 : 17 right tc ls THIRD
plot file("burst") using col("frame"):(val("springs") < 1e9 ? val("springs") : NaN) with linespoints ls FIRST, \
     file("calm") using col("frame"):col("springs") with lines ls SECOND, \
     file("calm") using col("frame"):col("links") with lines ls THIRD dt (6,4), \
     file("burst") using col("frame"):(val("springs") < 1e9 ? val("springs") : NaN):(sprintf("frame %d: %.3g m", val("frame"), val("springs"))) with labels hypertext point ls FIRST
