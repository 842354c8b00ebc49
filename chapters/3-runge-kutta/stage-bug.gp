eval axis_names("steps per second", "largest error in one turn  [m]")
set logscale xy
set xrange [0.85:160]
set yrange [2e-10:8]
set xtics (1, 2, 8, 32, 128)
set ytics ("1 nm" 1e-9, "1 µm" 1e-6, "1 mm" 1e-3, "1 m" 1)
set lmargin NARROW ? 7.5 : 8
unset mxtics
unset mytics
set label 1 "RK4" at 7,1e-5 right tc ls RK4
set label 2 "with the bug" at 14,1.5e-3 left tc ls SECOND
line = 0.01
set label 3 sprintf("%g cm", 100*line) at 150,0.022 right tc ls LIMIT
plot line with lines ls LIMIT, \
     file("stages") using col("steps per second"):col("bug") with linespoints ls SECOND, \
     file("stages") using col("steps per second"):col("RK4") with linespoints ls RK4, \
     file("stages") using col("steps per second"):col("bug"):(sprintf("with the bug, %.0f steps a second: %.2g m", val("steps per second"), val("bug"))) with labels hypertext point ls SECOND, \
     file("stages") using col("steps per second"):col("RK4"):(sprintf("RK4, %.0f steps a second: %.2g m", val("steps per second"), val("RK4"))) with labels hypertext point ls RK4
