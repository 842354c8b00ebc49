eval axis_names("step  [s]", "largest error  [m]")
set logscale xy
set xrange [0.0015:0.16]
set yrange [0.0005:0.5]
set xtics ("1/512" 1/512., "1/256" 1/256., "1/128" 1/128., "1/64" 1/64., "1/32" 1/32., "1/16" 1/16., "1/8" 1/8.)
if (NARROW) set xtics ("1/512" 1/512., "1/128" 1/128., "1/32" 1/32., "1/8" 1/8.)
set ytics ("1 mm" 0.001, "1 cm" 0.01, "10 cm" 0.1)
set lmargin 7.5
unset mxtics
set label 1 "Euler" at 1/20.,0.028 left tc ls EULER
set label 2 "with  {/:Italic a h}^2/2" at 1/45.,0.15 right tc ls CONSTANT_ACCELERATION
set label 3 "slope 1" at 1/560.,0.02 left tc ls EXACT
plot 4.9*x with lines ls CONTEXT, \
     file("order") using (1/val("steps per second")):col("Euler") with linespoints ls EULER, \
     file("order") using (1/val("steps per second")):col("with a h²/2") with linespoints ls CONSTANT_ACCELERATION, \
     file("order") using (1/val("steps per second")):col("Euler"):(sprintf("Euler, step 1/%.0f s: error %.2g m", val("steps per second"), val("Euler"))) with labels hypertext point ls EULER, \
     file("order") using (1/val("steps per second")):col("with a h²/2"):(sprintf("with the term, step 1/%.0f s: error %.2g m", val("steps per second"), val("with a h²/2"))) with labels hypertext point ls CONSTANT_ACCELERATION
