eval axis_names("particles", "time of a step of a particle  [ns]")
set logscale x
set xrange [3000:6.5e6]
set yrange [0:*]
set xtics ("4096" 4096, "65 536" 65536, "10^{6}" 1e6, "4×10^{6}" 4e6)
unset mxtics
set label 4 "grey: memory alone" at graph 0.99,NARROW ? 0.5 : 0.05 right tc rgb "#000009"
set x2range [0:1]
set y2range [0:1]
tip = "%d particles: %.2f ns"
plot file("particles") using 2:4 with linespoints ls FIRST, \
     file("particles") using 2:6 with linespoints ls CONTEXT lw 3, \
     file("particles") using 2:5 with linespoints ls SECOND, \
     file("particles") using 2:7 with linespoints ls THIRD, \
     file("particles") using 2:4:(sprintf(tip, $2, $4)) with labels hypertext point ls FIRST, \
     file("particles") using 2:5:(sprintf(tip, $2, $5)) with labels hypertext point ls SECOND, \
     file("particles") using 2:7:(sprintf(tip, $2, $7)) with labels hypertext point ls THIRD, \
     file("particles") every ::1::1 using 2:4:("one struct for each") with labels left offset 0,-0.8 tc ls FIRST, \
     file("particles") every ::1::1 using 2:5:("packs, one step a visit") with labels left offset 0,0.8 tc ls SECOND, \
     file("particles") every ::1::1 using 2:7:("packs, 16 steps a visit") with labels left offset 0,-0.9 tc ls THIRD, \
     file("particles") every ::1::1 using (1):(1):(strcol(3)) axes x2y2 with labels right offset 0,0.8 tc ls CONTEXT
