eval axis_names("iterations, or substeps, in a frame", "stretch of a hanging rope")
set logscale xy
set xrange [0.85:NARROW ? 350 : 170]
set yrange [0.004:200]
set xtics (1, 2, 4, 8, 16, 32, 64)
set ytics ("0.01 %%" 0.01, "0.1 %%" 0.1, "1 %%" 1, "10 %%" 10, "100 %%" 100)
unset mxtics
unset mytics
set lmargin NARROW ? 8 : 9
array count = [10, 20, 40]
rope(i) = i == 4 ? rope(2)." in substeps" : sprintf("%d links", count[i])
set label 1 rope(3) at 74,1.6 left tc ls FIRST
set label 2 rope(2) at 74,0.34 left tc ls SECOND
set label 3 rope(1) at 74,0.04 left tc ls THIRD
set label 4 rope(2).",\nsubsteps" at 7,0.12 right tc ls SECOND
tip(name) = sprintf("%d: %.3g per cent", val("iterations"), val(name))
plot file("stretch") using col("iterations"):col(rope(3)) with linespoints ls FIRST, \
     file("stretch") using col("iterations"):col(rope(2)) with linespoints ls SECOND, \
     file("stretch") using col("iterations"):col(rope(1)) with linespoints ls THIRD, \
     file("stretch") using col("iterations"):col(rope(4)) with linespoints ls SECOND dt (6,4) pt 4, \
     for [i=1:4] file("stretch") using col("iterations"):col(rope(i)):(tip(rope(i))) with labels hypertext point ls CONTEXT ps 0.3
