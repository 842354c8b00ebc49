eval axis_names("time  [s]", "velocity  [m/s]")
set xrange [-0.02:0.375]
set yrange [-2.4:2.4]
set xtics 0.1
set ytics 1
set label 1 "kick" at 0.138,-0.95 left tc ls SYMPLECTIC_EULER
set label 2 "drift" at 0.118,NARROW ? -1.72 : -1.64 left tc ls SYMPLECTIC_EULER
set label 3 "velocity Verlet" at 0.02,1.05 left tc ls VELOCITY_VERLET
set arrow 3 from 0.03,0.8 to 0.004,0.2 nohead ls CONTEXT
h = cell("kicks", 2, "t") - cell("kicks", 1, "t")
plot file("kicks-exact") using col("t"):col("v") with lines ls EXACT, \
     file("kicks") using col("t"):col("before"):(0):(val("after") - val("before")) with vectors nohead ls SYMPLECTIC_EULER lw 1.2, \
     file("kicks") using col("t"):col("after"):(h):(0) with vectors nohead ls SYMPLECTIC_EULER lw 2.4, \
     file("kicks") using (val("t") + h/2):col("after") with points ls EXACT pt 7 ps 0.5, \
     file("kicks") using col("t"):col("velocity Verlet") with points ls VELOCITY_VERLET ps 0.9, \
     file("kicks") using (val("t") + h/2):col("after"):(sprintf("between the kicks at %.2f and %.2f s: %.3f m/s", val("t"), val("t") + h, val("after"))) with labels hypertext point ls EXACT pt 7 ps 0.3, \
     file("kicks") using col("t"):col("velocity Verlet"):(sprintf("at %.2f s: %.3f m/s before the kick, %.3f after it, velocity Verlet %.3f", val("t"), val("before"), val("after"), val("velocity Verlet"))) with labels hypertext point ls VELOCITY_VERLET ps 0.3
