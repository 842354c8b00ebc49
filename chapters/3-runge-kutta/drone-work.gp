eval axis_names("evaluations per second", "largest error in one turn  [m]")
set logscale xy
set xrange [3.2:6500]
set yrange [3e-13:300]
set xtics (4, 16, 64, 256, 1024, 4096)
set ytics ("1 pm" 1e-12, "1 nm" 1e-9, "1 µm" 1e-6, "1 mm" 1e-3, "1 m" 1)
set lmargin NARROW ? 7.5 : 8
unset mxtics
unset mytics
set label 1 "Euler" at 1100,NARROW ? 0.2 : 0.09 left tc ls EULER
set label 2 "midpoint" at 1100,NARROW ? 3e-4 : 8e-5 left tc ls MIDPOINT
set label 5 NARROW ? "RK4, float" : "RK4 in float" at NARROW ? 500 : 450,NARROW ? 6e-7 : 3e-7 left tc ls RK4
set label 3 "RK4" at NARROW ? 100 : 130,1e-8 right tc ls RK4
line = 0.01
set label 4 sprintf("%g cm", 100*line) at 700,0.0032 center tc ls LIMIT
plot line with lines ls LIMIT, \
     file("work") using col("evaluations"):col("Euler") with linespoints ls EULER, \
     file("work") using col("evaluations"):col("midpoint") with linespoints ls MIDPOINT, \
     file("work") using col("evaluations"):col("RK4") with linespoints ls RK4, \
     file("work") using col("evaluations"):col("RK4 in float") with linespoints ls RK4 dt (2,3) pt 12, \
     file("work") using col("evaluations"):col("RK4 in float"):(sprintf("RK4 in float, %.0f evaluations a second: %.2g m", val("evaluations"), val("RK4 in float"))) with labels hypertext point ls RK4 pt 12, \
     file("work") using col("evaluations"):col("Euler"):(sprintf("Euler, %.0f evaluations a second: %.2g m", val("evaluations"), val("Euler"))) with labels hypertext point ls EULER, \
     file("work") using col("evaluations"):col("midpoint"):(sprintf("midpoint, %.0f evaluations a second: %.2g m", val("evaluations"), val("midpoint"))) with labels hypertext point ls MIDPOINT, \
     file("work") using col("evaluations"):col("RK4"):(sprintf("RK4, %.0f evaluations a second: %.2g m", val("evaluations"), val("RK4"))) with labels hypertext point ls RK4
