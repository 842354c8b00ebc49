eval canvas(300, 190)
unset border
unset tics
set lmargin 0
set rmargin 0
set tmargin 0
set bmargin 0
set size ratio -1
set xrange [-1.5:25]
set yrange [-12.5:3]
net(name, n) = txt("net") eq name ? n : NaN
set arrow 1 from 0,-0.8 to 0,0.8 nohead ls LIMIT dt solid
set label 1 "chain" at 24.5,1.6 right
set label 2 "rope" at 21,-4 right
set label 3 "cloth" at 7,-9.5 left
set clip two
plot file("cloth-links") using (val("x")):(val("y") - 6):col("right"):col("down") with vectors nohead ls CONTEXT lw 0.8, \
     file("beads") using (net("chain", val("x"))):(net("chain", 0)) with linespoints ls FIRST ps 0.4 lw 1, \
     file("beads") using (net("rope", 22)):(net("rope", val("y") - 2)) with linespoints ls SECOND pt 7 ps 0.4 lw 1, \
     file("beads") using (net("cloth", val("x"))):(net("cloth", val("y") - 6)) with points ls THIRD pt 7 ps 0.45, \
     file("beads") using (val("held") > 0 ? val("x") + (txt("net") eq "rope" ? 22 : 0) : NaN):(val("y") - (txt("net") eq "rope" ? 2 : 6)) with points ls EXACT pt 5 ps 0.6
