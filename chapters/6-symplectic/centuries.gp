eval axis_names("time  [years]", "largest energy error so far, relative")
set logscale xy
set xrange [0.5:NARROW ? 12000 : 6000]
set yrange [1e-8:3]
set xtics (1, 10, 100, number("years") exact("years"))
set ytics ("1" 1, "10^{-2}" 1e-2, "10^{-4}" 1e-4, "10^{-6}" 1e-6, "10^{-8}" 1e-8)
unset mxtics
unset mytics
set label 1 "Euler" at 680,0.68 left tc ls EULER
set label 2 "backward Euler" at 16,2 left tc ls BACKWARD_EULER
set label 3 NARROW ? "symplectic\nEuler" : "symplectic Euler" at 680,NARROW ? 1.1e-2 : 2e-3 left tc ls SYMPLECTIC_EULER
set label 4 "RK4" at 680,NARROW ? 1.4e-4 : 9e-5 left tc ls RK4
set label 5 NARROW ? "vel. Verlet" : "velocity Verlet" at 680,NARROW ? 1.5e-5 : 1.9e-5 left tc ls VELOCITY_VERLET
set label 6 "Yoshida" at 680,NARROW ? 1.6e-6 : 2.2e-6 left tc ls YOSHIDA4
tip = "after %.0f years: %.2g"
plot file("centuries") using col("year"):col("Euler") with lines ls EULER, \
     file("centuries") using col("year"):col("backward Euler") with lines ls BACKWARD_EULER, \
     file("centuries") using col("year"):col("symplectic Euler") with lines ls SYMPLECTIC_EULER, \
     file("centuries") using col("year"):col("velocity Verlet") with lines ls VELOCITY_VERLET, \
     file("centuries") using col("year"):col("RK4") with lines ls RK4, \
     file("centuries") using col("year"):col("Yoshida 4") with lines ls YOSHIDA4, \
     file("centuries") every 10 using col("year"):col("symplectic Euler"):(sprintf(tip, val("year"), val("symplectic Euler"))) with labels hypertext point ls SYMPLECTIC_EULER ps 0.3, \
     file("centuries") every 10 using col("year"):col("velocity Verlet"):(sprintf(tip, val("year"), val("velocity Verlet"))) with labels hypertext point ls VELOCITY_VERLET ps 0.3, \
     file("centuries") every 10 using col("year"):col("RK4"):(sprintf(tip, val("year"), val("RK4"))) with labels hypertext point ls RK4 ps 0.3, \
     file("centuries") every 10 using col("year"):col("Yoshida 4"):(sprintf(tip, val("year"), val("Yoshida 4"))) with labels hypertext point ls YOSHIDA4 ps 0.3
