eval axis_names("speed of the blow  [m/s]", "most energy, over that of the blow")
set logscale xy
set xrange [1:20]
set yrange [0.1:1e9]
set xtics (1, 2, 5, 10, 20)
set ytics ("0.1" 0.1, "1" 1, "10" 10, "100" 100, "10^{4}" 1e4, "10^{6}" 1e6, "10^{8}" 1e8)
unset mxtics
unset mytics
set lmargin NARROW ? 7.5 : 8
set rmargin NARROW ? 7 : 9
set key top left Left reverse
rope(method, name) = txt("net") eq "rope" && txt("method") eq method ? val(name) : NaN
methods = "'backward Euler' BDF2"
array ways = ["one solve", "two solves", "enough"]
array shown = ["once", "twice", "enough"]
last = 5
at_last(name, method) = cell("blows", method eq "BDF2" ? 2*last : last, name)
set label 1 shown[1] at 21,at_last(ways[1], "BDF2") left tc ls BDF2
set label 2 shown[2] at 21,at_last(ways[2], "BDF2") left tc ls BDF2
set label 3 shown[1] at 21,at_last(ways[1], "backward Euler") left tc ls BACKWARD_EULER
set label 4 shown[2] at 21,at_last(ways[2], "backward Euler") left tc ls BACKWARD_EULER
set label 5 shown[3] at 21,at_last(ways[3], "BDF2") left tc ls EXACT
tip(i) = sprintf("%s, %s, %.2g m/s: %.3g", txt("method"), shown[i], val("speed"), val(ways[i]))
of_rope(i) = txt("net") eq "rope" ? val(ways[i]) : NaN
plot 1 with lines ls LIMIT notitle, \
     for [m in methods] file("blows") using col("speed"):(rope(m, "one solve")) with linespoints ls style(m) dt (6,4) notitle, \
     for [m in methods] file("blows") using col("speed"):(rope(m, "two solves")) with linespoints ls style(m) dt (2,3) notitle, \
     for [m in methods] file("blows") using col("speed"):(rope(m, "enough")) with linespoints ls style(m) title m, \
     for [i=1:3] file("blows") using col("speed"):(of_rope(i)):(tip(i)) with labels hypertext point ls CONTEXT ps 0.2 notitle
