eval NARROW ? canvas(400, 430) : canvas(720, 470)
eval axis_names("evaluations per second of play", NARROW ? "energy error in a minute" : "largest relative change of the energy in a minute")
set logscale xy
set xrange [25:NARROW ? 5000 : 3600]
set xtics (30, 60, 120, 240, 480, 960)
if (NARROW) set xtics (30, 120, 480)
set yrange [1e-12:10]
set ytics ("10^{-2}" 1e-2, "10^{-4}" 1e-4, "10^{-6}" 1e-6, "10^{-8}" 1e-8, "10^{-10}" 1e-10)
unset mxtics
unset mytics
set lmargin NARROW ? 7.5 : 8
# Those whose line would hide another's are left out.
left_out = "'leapfrog' 'Störmer–Verlet' 'Heun' 'predicted Euler' 'BDF2'"
methods = ""
do for [m in each("work-energy", "method")] { if (!strstrt(left_out, "'".m."'")) { methods = methods."'".m."' " } }
of(m) = txt("method") eq m ? val("evaluations per second") : NaN
at(m, rate) = val("steps per second") == rate ? of(m) : NaN
plot for [m in methods] file("work-energy") using (of(m)):col("energy error") with linespoints ls style(m), \
     for [m in methods] file("work-energy") using (of(m)):col("energy error"):(sprintf("%s, %d steps a second: %.2g", m, val("steps per second"), val("energy error"))) with labels hypertext point ls style(m), \
     file("work-energy") using (at("Euler", 30)):col("energy error"):("Euler") with labels left offset -0.4,0.7 tc ls style("Euler"), \
     file("work-energy") using (at("symplectic Euler", 240)):col("energy error"):("symplectic Euler") with labels left offset 0.8,0.4 tc ls style("symplectic Euler"), \
     file("work-energy") using (at("velocity Verlet", 30)):col("energy error"):(NARROW ? "Verlet" : "velocity Verlet") with labels left offset -0.4,(NARROW ? -1.6 : -1.4) tc ls style("velocity Verlet"), \
     file("work-energy") using (at("Yoshida 4", 240)):col("energy error"):("Yoshida") with labels left offset 0.8,0.2 tc ls style("Yoshida 4"), \
     file("work-energy") using (at("midpoint", 240)):col("energy error"):("midpoint") with labels left offset 0.2,-0.8 tc ls style("midpoint"), \
     file("work-energy") using (at("RK4", 240)):col("energy error"):("RK4") with labels left offset 0.8,0 tc ls style("RK4"), \
     file("work-energy") using (at("Dormand-Prince", 240)):col("energy error"):("Dormand-Prince") with labels right offset -0.6,-0.35 tc ls style("Dormand-Prince"), \
     file("work-energy") using (at("trapezoid", 240)):col("energy error"):("trapezoid") with labels left offset 0.8,0.3 tc ls style("trapezoid")
