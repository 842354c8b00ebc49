eval axis_names("time  [s]", "evaluations in this frame")
set xrange [8:12]
set yrange [0:95]
set xtics 1
set ytics 0,20
set label 1 "nearest the sun" at 9.9,88 right tc rgb "#000007"
set label 2 "7 in all others" at 10.35,13 left tc rgb "#00000b"
plot file("comet") using 1:2 with impulses ls SECOND lw (NARROW ? 0.7 : 1.4), \
     file("comet") using ($1 > 8 && $1 < 12 ? $1 : NaN):2:(sprintf("frame at %.2f s: %.0f evaluations", $1, $2)) with labels hypertext point ls SECOND ps 0.2
