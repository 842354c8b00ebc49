eval canvas(300, 260)
unset border
unset tics
set lmargin 0
set rmargin 0
set tmargin 0
set bmargin 0
set size ratio -1
set xrange [-0.4:2.2]
set yrange [-2.05:0.2]
beads = int(exact("rope-beads"))
set label 9 "" at 0,0 point ls EXACT pt 7 ps 0.9
plot file("rope") using col("x"):col("y") with points ls CONTEXT ps 0.4, \
     for [shape=0:5] file("rope") every ::beads*shape+1::beads*(shape+1) using col("x"):col("y") with lines ls (shape == 0 ? SECOND : FIRST) lw 1.2
