if (NARROW) eval canvas(400, 430)
eval axis_names("unknowns", "multiplications per unknown and frame")
set logscale xy
set xrange [80:NARROW ? 14000 : 30000]
set yrange [8:14000]
set xtics (100, 300, 1000, 3000, 10000)
if (NARROW) set xtics (100, 1000, 10000)
set ytics (10, 100, 1000, 10000)
set lmargin NARROW ? 7.5 : 8
unset mxtics
unset mytics
set label 1 "cloth, solved" at 7000,7200 right tc rgb "#00000c"
set label 2 NARROW ? "substeps" : "cloth, substeps" at NARROW ? 2200 : 11500,NARROW ? 1050 : 1500 left tc rgb "#00000c"
set label 3 "rope, substeps" at NARROW ? 1100 : 900,NARROW ? 530 : 510 center tc rgb "#00000b"
set label 4 "rope, solved" at 900,84 center tc rgb "#00000b"
set label 5 "chain, substeps" at 900,NARROW ? 175 : 190 center tc rgb "#00000a"
set label 6 "chain, solved" at 900,14 center tc rgb "#00000a"
plot file("work") every ::1::3 using 2:4 with linespoints ls FIRST, \
     file("work") every ::1::3 using 2:6 with linespoints ls FIRST dt (6,4), \
     file("work") every ::4::6 using 2:4 with linespoints ls SECOND, \
     file("work") every ::4::6 using 2:6 with linespoints ls SECOND dt (6,4), \
     file("work") every ::7::11 using 2:4 with linespoints ls THIRD, \
     file("work") every ::7::11 using 2:6 with linespoints ls THIRD dt (6,4), \
     file("work") using 2:4:(sprintf("%s, %d unknowns, solved: %.0f", strcol(1), $2, $4)) with labels hypertext point ls CONTEXT, \
     file("work") using 2:6:(sprintf("%s, %d unknowns, %d substeps: %.0f", strcol(1), $2, $5, $6)) with labels hypertext point ls CONTEXT
