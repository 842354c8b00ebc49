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
set label 1 "cloth, solved" at 7000,7200 right tc ls THIRD
set label 2 NARROW ? "substeps" : "cloth, substeps" at NARROW ? 2200 : 11500,NARROW ? 1050 : 1500 left tc ls THIRD
set label 3 "rope, substeps" at NARROW ? 1100 : 900,NARROW ? 530 : 510 center tc ls SECOND
set label 4 "rope, solved" at 900,84 center tc ls SECOND
set label 5 "chain, substeps" at 900,NARROW ? 175 : 190 center tc ls FIRST
set label 6 "chain, solved" at 900,14 center tc ls FIRST
# The chain is one scene; the cloths bear their sizes in their names.
of(thing) = txt("scene")[1:strlen(thing)] eq thing ? val("unknowns") : NaN
plot file("work") using (of("chain")):col("solving") with linespoints ls FIRST, \
     file("work") using (of("chain")):col("all substeps") with linespoints ls FIRST dt (6,4), \
     file("work") using (of("rope")):col("solving") with linespoints ls SECOND, \
     file("work") using (of("rope")):col("all substeps") with linespoints ls SECOND dt (6,4), \
     file("work") using (of("cloth")):col("solving") with linespoints ls THIRD, \
     file("work") using (of("cloth")):col("all substeps") with linespoints ls THIRD dt (6,4), \
     file("work") using col("unknowns"):col("solving"):(sprintf("%s, %d unknowns, solved: %.0f", txt("scene"), val("unknowns"), val("solving"))) with labels hypertext point ls CONTEXT, \
     file("work") using col("unknowns"):col("all substeps"):(sprintf("%s, %d unknowns, %d substeps: %.0f", txt("scene"), val("unknowns"), val("substeps"), val("all substeps"))) with labels hypertext point ls CONTEXT
