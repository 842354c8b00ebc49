eval NARROW ? canvas(400, 430) : canvas(720, 470)
eval axis_names("evaluations per second of play", "largest error in a second  [m]")
set logscale xy
set xrange [25:NARROW ? 5000 : 3600]
set xtics (30, 60, 120, 240, 480, 960)
if (NARROW) set xtics (30, 120, 480)
set yrange [1e-10:10]
set ytics ("1 m" 1, "1 cm" 1e-2, "0.1 mm" 1e-4, "1 µm" 1e-6, "10 nm" 1e-8)
unset mxtics
unset mytics
set lmargin NARROW ? 7.5 : 8
methods = "Euler 'symplectic Euler' 'velocity Verlet' 'Yoshida 4' midpoint RK4 Dormand-Prince 'backward Euler' trapezoid"
of(m) = txt("method") eq m ? val("evaluations per second") : NaN
at(m, rate) = val("steps per second") == rate ? of(m) : NaN
aside = NARROW ? "left offset 1.4,-2" : "right offset -0.6,-0.9"
plot for [m in methods] file("work-suspension") using (of(m)):col("largest error") with linespoints ls style(m), \
     for [m in methods] file("work-suspension") using (of(m)):col("largest error"):(sprintf("%s, %d steps a second: %.2g m", m, val("steps per second"), val("largest error"))) with labels hypertext point ls style(m), \
     file("work-suspension") using (at("Euler", 30)):col("largest error"):("Euler") with labels left offset 1,0.2 tc ls style("Euler"), \
     file("work-suspension") using (at("symplectic Euler", 240)):col("largest error"):("symplectic Euler") with labels left offset 0.8,0 tc ls style("symplectic Euler"), \
     file("work-suspension") using (at("velocity Verlet", 30)):col("largest error"):(NARROW ? "Verlet" : "velocity Verlet") with labels left offset -0.4,(NARROW ? -2.3 : -2) tc ls style("velocity Verlet"), \
     file("work-suspension") using (at("Yoshida 4", 240)):col("largest error"):("Yoshida") with labels left offset 0.8,0.35 tc ls style("Yoshida 4"), \
     file("work-suspension") using (at("midpoint", 240)):col("largest error"):("midpoint") with labels @aside tc ls style("midpoint"), \
     file("work-suspension") using (at("RK4", 240)):col("largest error"):("RK4") with labels left offset 0.8,0 tc ls style("RK4"), \
     file("work-suspension") using (at("Dormand-Prince", 240)):col("largest error"):("Dormand-Prince") with labels right offset -0.6,-0.35 tc ls style("Dormand-Prince"), \
     file("work-suspension") using (at("backward Euler", 240)):col("largest error"):("backward Euler") with labels left offset 0.8,0.1 tc ls style("backward Euler"), \
     file("work-suspension") using (at("trapezoid", 240)):col("largest error"):("trapezoid") with labels left offset 0.8,-0.45 tc ls style("trapezoid")
