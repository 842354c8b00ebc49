eval NARROW ? canvas(400, 400) : canvas(600, 540)
eval axis_names("x  [m]", "y  [m]")
set size ratio -1
set xrange [-0.8:1.6]
set yrange [-2.1:0.2]
set xtics 1
set ytics 1
set object 1 circle at 0,exact("peg-height") size exact("peg-radius") fillstyle solid noborder fillcolor rgb "#000009"
pulls = number("weight-pulls")
end(name) = cell("two-ropes", rows("two-ropes"), name)
set label 1 pulls." iterations" at 0.33,-1.96 left tc ls FIRST
set label 2 pulls." substeps" at -0.24,-1.42 right tc ls SECOND
set label 3 "" at end("x"),end("y") point ls FIRST ps 1.9
set label 4 "" at end("x in substeps"),end("y in substeps") point ls SECOND ps 1.8
plot file("two-weights") using col("x"):col("y") with lines ls FIRST lw 1 dt (2,4), \
     file("two-weights") using col("x in substeps"):col("y in substeps") with lines ls SECOND lw 1 dt (2,4), \
     file("two-ropes") using col("x"):col("y") with linespoints ls FIRST lw 1.6 ps 0.45, \
     file("two-ropes") using col("x in substeps"):col("y in substeps") with linespoints ls SECOND lw 1.6 ps 0.4
