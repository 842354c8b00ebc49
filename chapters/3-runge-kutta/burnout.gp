eval axis_names("steps per second", "error of the height  [m]")
set logscale xy
set xrange [3.4:1300]
set yrange [3e-14:60]
set xtics (4, 16, 64, 256, 1024)
set ytics ("1 pm" 1e-12, "1 nm" 1e-9, "1 µm" 1e-6, "1 mm" 1e-3, "1 m" 1)
set lmargin NARROW ? 7.5 : 8
unset mxtics
unset mytics
set label 1 "a step across the burnout" at NARROW ? 1200 : 1000,NARROW ? 14 : 1.3 right tc ls RK4
set label 2 NARROW ? "cut there" : "the step cut there" at NARROW ? 5 : 10,3e-11 left tc ls RK4
set label 3 "slope −1" at 5,NARROW ? 0.007 : 0.05 left tc ls EXACT
plot 2/x with lines ls CONTEXT, \
     file("burnout") using col("steps per second"):col("across") with points ls RK4 pt 12, \
     file("burnout") using col("steps per second"):col("cut") with points ls RK4, \
     file("burnout") using col("steps per second"):col("across"):(sprintf("%.0f steps a second, across: %.2g m", val("steps per second"), val("across"))) with labels hypertext point ls RK4 pt 12, \
     file("burnout") using col("steps per second"):col("cut"):(sprintf("%.0f steps a second, cut: %.2g m", val("steps per second"), val("cut"))) with labels hypertext point ls RK4
