eval axis_names("frame", "moved since the frame before  [cm]")
last = NARROW ? 20 : 40
set xrange [-0.7:last + (NARROW ? 4.5 : 5)]
set yrange [0:6.2]
set xtics 0,5,last
set ytics 0,1
set grid noxtics
set label 1 "newest state" at 0,5.6 left tc ls FIRST
set label 2 "blended" at last,2.08 left offset 0.5,0 tc ls SECOND
plot file("display") every ::9::last + 8 using (val("frame") - 8):col("newest state") with impulses ls FIRST lw 3, \
     file("display") every ::9::last + 8 using (val("frame") - 8):col("newest state") with points ls FIRST, \
     file("display") every ::9::last + 8 using (val("frame") - 8):col("blended") with linespoints ls SECOND lw 1.4, \
     file("display") every ::9::last + 8 using (val("frame") - 8):col("newest state"):(sprintf("newest state: %.2f cm", val("newest state"))) with labels hypertext point ls FIRST, \
     file("display") every ::9::last + 8 using (val("frame") - 8):col("blended"):(sprintf("blended: %.2f cm", val("blended"))) with labels hypertext point ls SECOND
