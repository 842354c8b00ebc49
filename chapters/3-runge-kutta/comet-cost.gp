eval axis_names("time  [s]", "evaluations in this frame")
set xrange [9.5:10.5]
set yrange [0:95]
set xtics 0.25
set ytics 0,20
set label 1 "nearest the sun" at 9.93,88 right tc ls EXACT
set label 2 number("comet-cheapest")." in most frames" at 10.49,NARROW ? 27 : 13 right tc ls DOPRI5
plot file("comet") using col("t"):col("evaluations") with impulses ls DOPRI5 dt 1 lw (NARROW ? 2 : 4), \
     file("comet") using (val("t") > 9.5 && val("t") < 10.5 ? val("t") : NaN):col("evaluations"):(sprintf("frame at %.2f s: %.0f evaluations", val("t"), val("evaluations"))) with labels hypertext point ls DOPRI5 dt 1 ps 0.2
