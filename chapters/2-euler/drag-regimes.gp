eval axis_names("time  [s]", "falling speed  [m/s]")
set xrange [0:9]
set yrange [-2.2:13]
set xtics 0,3
set ytics 0,5
set label 1 "{/:Italic ch} = 0.5" at NARROW ? 6.4 : 0.5,NARROW ? 3.2 : 1.7 left tc rgb "#000001"
set label 2 "1.5" at NARROW ? 1.65 : 2.3,NARROW ? 6.9 : 6.3 left tc rgb "#00000a"
set label 3 "2.1" at NARROW ? 5.75 : 5.5,NARROW ? 12.2 : 11.6 left tc rgb "#00000c"
if (!NARROW) set label 4 "true" at 7.2,4 left tc rgb "#000007"
names(i) = word("drag-5 drag-15 drag-21", i)
ch(i) = word("0.5 1.5 2.1", i)
style(i) = i == 3 ? THIRD : i == 2 ? FIRST : EULER
plot 4.905*(1 - exp(-2*x)) with lines ls EXACT, \
     file("drag-21") using col("t"):(-val("v")) with linespoints ls THIRD pt 7 lw 1.6, \
     file("drag-15") using col("t"):(-val("v")) with linespoints ls FIRST pt 5 lw 1.6, \
     file("drag-5") using col("t"):(-val("v")) with linespoints ls EULER lw 1.6, \
     for [i=1:3] file(names(i)) using col("t"):(-val("v")):(sprintf("ch = %s, at %.2f s: %.2f m/s", ch(i), val("t"), -val("v"))) \
       with labels hypertext point ls style(i)
