eval NARROW ? canvas(400, 220) : canvas(720, 220)
# A lane of frames, a lane of steps below, and in between the time that each frame leaves over.
shown = NARROW ? 7 : 8
unset border
set xlabel "time  [ms]" offset 0,0.3
last = cell("frame-line", shown, "ends")
set xrange [0:last + 2]
set yrange [-0.2:3.6]
set xtics 50
unset ytics
set grid noxtics noytics
set lmargin NARROW ? 7 : 8
set tmargin 0.6
set label 1 "frames" at graph 0,first 2.9 right offset -1,0 tc ls FIRST
set label 2 "saved" at graph 0,first 1.95 right offset -1,0 tc ls THIRD
set label 3 "steps" at graph 0,first 0.5 right offset -1,0 tc ls SECOND
plot file("frame-line") every ::::shown using (val("begins")/2 + val("ends")/2):(2.9):col("begins"):col("ends"):(2.4):(3.4) with boxxyerror ls FIRST fs transparent solid 0.25 border, \
     file("step-line") using (val("paid") > last ? NaN : val("begins")/2 + val("ends")/2):(0.5):col("begins"):col("ends"):(0):(1) with boxxyerror ls SECOND fs transparent solid 0.25 border, \
     file("step-line") using (val("paid") > last ? NaN : val("paid")):(2.4):((val("begins") + val("ends"))/2 - val("paid")):(-1.4) with vectors nohead ls CONTEXT, \
     file("frame-line") every ::::shown using (val("spent")/2 + val("ends")/2):(1.95):col("spent"):col("ends"):(1.75):(2.15) with boxxyerror ls THIRD fs solid noborder, \
     file("frame-line") every ::::shown using (val("begins")/2 + val("ends")/2):(2.9):(sprintf("a frame of %.1f ms; then %.1f ms are left over", val("ends") - val("begins"), val("ends") - val("spent"))) with labels hypertext point ls FIRST ps 0.3, \
     file("step-line") using (val("paid") > last ? NaN : val("begins")/2 + val("ends")/2):(0.5):(sprintf("a step from %.1f to %.1f ms, taken at %.1f ms", val("begins"), val("ends"), val("paid"))) with labels hypertext point ls SECOND ps 0.3
