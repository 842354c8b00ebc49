eval axis_names("time  [s]", "velocity  [m/s]")
set xrange [0:0.53]
set yrange [0:5.6]
set xtics 0.1
set ytics 1
set label 1 "above the line: too much" at 0.2,4.6 left tc ls EULER
set label 2 "under it: the jump" at 0.025,NARROW ? 0.6 : 0.5 left tc ls EXACT
table = file("jump-area")
plot table using (val("t")/2 + val("ends")/2):(0):(val("t")):(val("ends")):(0):col("v") with boxxyerror ls EULER lw 0.7 fs transparent solid 0.3 border, \
     table using (val("t")/2 + val("ends")/2):col("v"):(sprintf("from %.2f to %.2f s: %.2f m/s for %.2f s add %.1f cm", val("t"), val("ends"), val("v"), val("ends") - val("t"), 100*val("v")*(val("ends") - val("t")))) with labels hypertext point ls EULER ps 0.3, \
     table using (val("t")):(val("v")):(val("ends") - val("t")):(val("v then") - val("v")) with vectors nohead ls EXACT dt solid lw 2
