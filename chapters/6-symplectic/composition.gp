eval axis_names("evaluations per second", "largest error in a second  [m]")
set logscale xy
set xrange [100:NARROW ? 150000 : 50000]
set yrange [5e-11:0.1]
set xtics (120, 480, 1920, 7680)
if (NARROW) set xtics (120, 960, 7680)
set ytics ("10^{-2}" 1e-2, "10^{-4}" 1e-4, "10^{-6}" 1e-6, "10^{-8}" 1e-8, "10^{-10}" 1e-10)
unset mxtics
unset mytics
set label 1 "symplectic Euler" at 8800,1.6e-4 left tc ls SYMPLECTIC_EULER
set label 2 "Yoshida, damped" at 8800,5e-6 left tc ls YOSHIDA4
set label 3 NARROW ? "Verlet" : "velocity Verlet" at 8800,5e-7 left tc ls VELOCITY_VERLET
set label 6 NARROW ? "Verlet, damped" : "velocity Verlet, damped" at 8800,6e-8 left tc ls VELOCITY_VERLET
set label 4 "Yoshida" at 8800,1.3e-9 left tc ls YOSHIDA4
set label 5 "RK4" at 8800,2e-10 left tc ls RK4
tip = "%d evaluations: %.2g m"
plot file("composition") using col("evaluations per second"):col("symplectic Euler") with linespoints ls SYMPLECTIC_EULER, \
     file("composition") using col("evaluations per second"):col("velocity Verlet") with linespoints ls VELOCITY_VERLET, \
     file("composition") using col("evaluations per second"):col("Yoshida 4") with linespoints ls YOSHIDA4, \
     file("composition") using col("evaluations per second"):col("RK4") with linespoints ls RK4, \
     file("composition") using col("evaluations per second"):col("velocity Verlet damped") with linespoints ls VELOCITY_VERLET dt (5,4) pt 8, \
     file("composition") using col("evaluations per second"):col("Yoshida 4 damped") with linespoints ls YOSHIDA4 dt (5,4) pt 6, \
     file("composition") using col("evaluations per second"):col("symplectic Euler"):(sprintf(tip, val("evaluations per second"), val("symplectic Euler"))) with labels hypertext point ls SYMPLECTIC_EULER, \
     file("composition") using col("evaluations per second"):col("velocity Verlet"):(sprintf(tip, val("evaluations per second"), val("velocity Verlet"))) with labels hypertext point ls VELOCITY_VERLET, \
     file("composition") using col("evaluations per second"):col("Yoshida 4"):(sprintf(tip, val("evaluations per second"), val("Yoshida 4"))) with labels hypertext point ls YOSHIDA4, \
     file("composition") using col("evaluations per second"):col("RK4"):(sprintf(tip, val("evaluations per second"), val("RK4"))) with labels hypertext point ls RK4, \
     file("composition") using col("evaluations per second"):col("velocity Verlet damped"):(sprintf(tip, val("evaluations per second"), val("velocity Verlet damped"))) with labels hypertext point ls VELOCITY_VERLET, \
     file("composition") using col("evaluations per second"):col("Yoshida 4 damped"):(sprintf(tip, val("evaluations per second"), val("Yoshida 4 damped"))) with labels hypertext point ls YOSHIDA4
