eval NARROW ? canvas(400, 430) : canvas(720, 470)
eval axis_names("steps per second", "largest error in one turn  [m]")
set logscale xy
set xrange [25:NARROW ? 12000 : 12000]
set yrange [1e-13:100]
set xtics (30, 120, 480, 1920, 7680)
set ytics ("1 m" 1, "1 cm" 1e-2, "0.1 mm" 1e-4, "1 µm" 1e-6, "10 nm" 1e-8, "0.1 nm" 1e-10)
unset mxtics
unset mytics
set lmargin NARROW ? 7.5 : 8
set label 1 "symplectic Euler" at 500,NARROW ? 2 : 0.8 left tc ls SYMPLECTIC_EULER
set label 2 NARROW ? "Verlet" : "velocity Verlet" at NARROW ? 28 : 30,0.012 left tc ls VELOCITY_VERLET
set label 3 "RK4 in float" at 1000,NARROW ? 1e-5 : 3e-5 left tc ls RK4
set label 5 NARROW ? "sums\nkept" : "sums compensated" at 2400,NARROW ? 3e-7 : 6e-7 left tc ls RK4
set label 4 "RK4 in double" at 760,3e-11 right tc ls RK4
tip = "%d steps a second: %.2g m in double, %.2g m in float"
plot file("floor") using col("steps per second"):col("symplectic Euler") with lines ls SYMPLECTIC_EULER dt solid lw 1.2, file("floor") using col("steps per second"):col("symplectic Euler float") with linespoints ls SYMPLECTIC_EULER, \
     file("floor") using col("steps per second"):col("velocity Verlet") with lines ls VELOCITY_VERLET lw 1.2, file("floor") using col("steps per second"):col("velocity Verlet float") with linespoints ls VELOCITY_VERLET, \
     file("floor") using col("steps per second"):col("RK4") with lines ls RK4 lw 1.2, file("floor") using col("steps per second"):col("RK4 float") with linespoints ls RK4, \
     file("floor") using col("steps per second"):col("RK4 compensated") with linespoints ls RK4 dt (6,4) pt 12, \
     file("floor") using col("steps per second"):col("symplectic Euler float"):(sprintf(tip, val("steps per second"), val("symplectic Euler"), val("symplectic Euler float"))) with labels hypertext point ls SYMPLECTIC_EULER, \
     file("floor") using col("steps per second"):col("velocity Verlet float"):(sprintf(tip, val("steps per second"), val("velocity Verlet"), val("velocity Verlet float"))) with labels hypertext point ls VELOCITY_VERLET, \
     file("floor") using col("steps per second"):col("RK4 float"):(sprintf(tip, val("steps per second"), val("RK4"), val("RK4 float"))) with labels hypertext point ls RK4
