eval NARROW ? canvas(400, 430) : canvas(720, 470)
eval axis_names(sprintf("time per second of play, one of %s shuttles  [µs]", number("shuttles-at-once")), "largest error in one turn  [m]")
set logscale xy
set xrange [NARROW ? 0.01 : 0.02:NARROW ? 200 : 30]
set xtics (0.1, 1, 10)
set yrange [1e-11:1000]
set ytics ("1 m" 1, "1 cm" 1e-2, "0.1 mm" 1e-4, "1 µm" 1e-6, "10 nm" 1e-8)
unset mxtics
unset mytics
set lmargin NARROW ? 7.5 : 8
methods = "Euler 'symplectic Euler' 'velocity Verlet' 'Yoshida 4' midpoint RK4 Dormand-Prince 'backward Euler' trapezoid"
of(m) = txt("method") eq m ? val("time per second of play") : NaN
at(m, rate) = val("steps per second") == rate ? of(m) : NaN
plot for [m in methods] file("work-time") using (of(m)):col("largest error") with linespoints ls style(m), \
     for [m in methods] file("work-time") using (of(m)):col("largest error"):(sprintf("%s, %d steps a second: %.2g m", m, val("steps per second"), val("largest error"))) with labels hypertext point ls style(m), \
     file("work-time") using (at("Euler", 30)):col("largest error"):("Euler") with labels right offset -0.8,0.1 tc ls style("Euler"), \
     file("work-time") using (at("symplectic Euler", 30)):col("largest error"):(NARROW ? "symplectic" : "symplectic Euler") with labels right offset -0.8,0.1 tc ls style("symplectic Euler"), \
     file("work-time") using (at("velocity Verlet", 30)):col("largest error"):(NARROW ? "Verlet" : "velocity Verlet") with labels right offset -0.8,-0.6 tc ls style("velocity Verlet"), \
     file("work-time") using (at("Yoshida 4", 240)):col("largest error"):("Yoshida") with labels left offset 0.8,0 tc ls style("Yoshida 4"), \
     file("work-time") using (at("midpoint", 240)):col("largest error"):("midpoint") with labels left offset 0.6,-0.6 tc ls style("midpoint"), \
     file("work-time") using (at("RK4", 240)):col("largest error"):("RK4") with labels left offset 0.8,0.2 tc ls style("RK4"), \
     file("work-time") using (at("Dormand-Prince", 240)):col("largest error"):("Dormand-Prince") with labels right offset -0.6,-0.35 tc ls style("Dormand-Prince"), \
     file("work-time") using (at("backward Euler", 240)):col("largest error"):("backward Euler") with labels left offset 0.8,0 tc ls style("backward Euler"), \
     file("work-time") using (at("trapezoid", 240)):col("largest error"):("trapezoid") with labels left offset 0.8,0.2 tc ls style("trapezoid")
