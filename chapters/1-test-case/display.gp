eval axis_names("frame", "where the runner is drawn  [cm]")
last = NARROW ? 12 : 19
set xrange [-0.5:last + 0.5]
set yrange [0:2.2*last]
set xtics 0,4
set ytics 0,10
set label 1 "newest state" at 0.42*last,1.3*last right tc ls FIRST
set label 2 "blended" at 0.7*last,1.05*last left tc ls SECOND
from = cell("display", 10, "blended")
plot file("display") every ::9::last + 9 using (val("frame") - 9):(val("newest state") - from) with steps ls FIRST lw 1, \
     file("display") every ::9::last + 9 using (val("frame") - 9):(val("newest state") - from) with points ls FIRST, \
     file("display") every ::9::last + 9 using (val("frame") - 9):(val("blended") - from) with linespoints ls SECOND lw 1.4, \
     file("display") every ::9::last + 9 using (val("frame") - 9):(val("newest state") - from):(sprintf("newest state: %.2f cm", val("newest state"))) with labels hypertext point ls FIRST, \
     file("display") every ::9::last + 9 using (val("frame") - 9):(val("blended") - from):(sprintf("blended: %.2f cm", val("blended"))) with labels hypertext point ls SECOND
