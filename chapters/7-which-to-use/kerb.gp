eval NARROW ? canvas(400, 430) : canvas(720, 430)
eval axis_names("evaluations per second of play", NARROW ? "largest error" : "largest error of wheel and chassis, at the worst moment")
set logscale xy
set xrange [50:7000]
set xtics (60, 120, 240, 480, 960, 1920, 3840)
if (NARROW) set xtics (60, 240, 960, 3840)
set yrange [5e-7:2]
set ytics ("1 µm" 1e-6, "10 µm" 1e-5, "0.1 mm" 1e-4, "1 mm" 1e-3, "1 cm" 0.01, "10 cm" 0.1, "1 m" 1)
unset mxtics
unset mytics
set lmargin NARROW ? 8 : 9
set arrow 1 from graph 0,first 0.01 to graph 1,first 0.01 nohead ls LIMIT
methods = "Euler 'symplectic Euler' 'damper divided' 'velocity Verlet' RK4 Dormand-Prince 'backward Euler' trapezoid"
look(m) = m eq "damper divided" ? style("symplectic Euler, drag divided") : style(m)
of(m) = txt("method") eq m ? val("evaluations a second") : NaN
at(m, steps) = val("steps a frame") == steps ? of(m) : NaN
tip(m) = txt("method") eq m ? sprintf("%s, %d steps a frame: %.2g m", m, val("steps a frame"), val("error")) : ""
plot for [m in methods] file("kerb") using (of(m)):(val("error")) with linespoints ls look(m), \
     for [m in methods] file("kerb") using (of(m)):(val("error")):(tip(m)) with labels hypertext point ls look(m), \
     file("kerb") using (at("Euler", 1)):(val("error")):("Euler") with labels left offset 0.8,0.3 tc ls style("Euler"), \
     file("kerb") using (at("velocity Verlet", 1)):(val("error")):(NARROW ? "Verlet" : "velocity Verlet") with labels left offset 0.8,0.3 tc ls style("velocity Verlet"), \
     file("kerb") using (at("symplectic Euler", 24)):(val("error")):(NARROW ? "symplectic" : "symplectic Euler") with labels left offset 0.8,-0.2 tc ls style("symplectic Euler"), \
     file("kerb") using (at("backward Euler", 24)):(val("error")):(NARROW ? "backward" : "backward Euler") with labels left offset 0.6,0.1 tc ls style("backward Euler"), \
     file("kerb") using (at("RK4", 24)):(val("error")):("RK4") with labels left offset -0.6,-0.9 tc ls style("RK4"), \
     file("kerb") using (at("trapezoid", 24)):(val("error")):("trapezoid") with labels right offset (NARROW ? 2.5 : 3),1 tc ls style("trapezoid"), \
     file("kerb") using (at("Dormand-Prince", 6)):(val("error")):("Dormand-Prince") with labels right offset -0.6,-0.7 tc ls style("Dormand-Prince")
