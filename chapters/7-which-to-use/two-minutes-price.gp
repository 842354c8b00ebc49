eval NARROW ? canvas(400, 430) : canvas(720, 430)
eval axis_names(NARROW ? "share of a frame, for a thousand" : "share of a frame at 60 a second, for a thousand of them", NARROW ? "largest error" : "largest error of a suspension")
set logscale xy
set xrange [NARROW ? 0.0004 : 0.0007 : 2]
set xtics ("0.001 %%" 0.001, "0.003 %%" 0.003, "0.01 %%" 0.01, "0.03 %%" 0.03, "0.1 %%" 0.1, "0.3 %%" 0.3, "1 %%" 1)
if (NARROW) set xtics ("0.001 %%" 0.001, "0.01 %%" 0.01, "0.1 %%" 0.1, "1 %%" 1)
set yrange [5e-10:20]
set ytics ("1 nm" 1e-9, "1 µm" 1e-6, "1 mm" 1e-3, "1 cm" 0.01, "1 m" 1)
unset mxtics
unset mytics
set lmargin NARROW ? 6.5 : 7
set rmargin NARROW ? 2 : 3
set arrow 1 from graph 0,first 0.01 to graph 1,first 0.01 nohead ls LIMIT
set arrow 2 from 1,graph 0 to 1,graph 1 nohead ls LIMIT
array methods = ["Euler", "symplectic Euler", "drag divided", "velocity Verlet", "RK4"]
look(m) = m eq "drag divided" ? style("symplectic Euler, drag divided") : style(m)
# A microsecond for a second of play of one is a tenth of a per cent for a thousand.
share(i) = val("microseconds")/10
mine(m) = txt("thing") eq "suspension" && txt("method") eq m
of(m) = mine(m) ? share(0) : NaN
at(m, rate) = mine(m) && val("steps per second") == rate ? share(0) : NaN
tip(m) = mine(m) ? sprintf("%s, %d steps a second: %.2g m for %.2g %% of a frame", m, val("steps per second"), val("error"), share(0)) : ""
exact_of(i) = txt("thing") eq "suspension" && txt("function") eq "spring_folded" ? share(0) : NaN
exact_at(rate) = val("steps per second") == rate ? exact_of(0) : NaN
exact_tip(i) = txt("thing") eq "suspension" ? sprintf("exact step by spring_folded, %d steps a second: rounding, for %.2g %% of a frame", val("steps per second"), share(0)) : ""
plot for [i=1:5] file("work") using (of(methods[i])):(val("error")) with linespoints ls look(methods[i]), \
     for [i=1:5] file("work") using (of(methods[i])):(val("error")):(tip(methods[i])) with labels hypertext point ls look(methods[i]), \
     file("work-exact") using (exact_of(0)):(1e-9) with linespoints ls EXACT dt solid pt 7, \
     file("work-exact") using (exact_of(0)):(1e-9):(exact_tip(0)) with labels hypertext point ls EXACT pt 7, \
     file("work") using (at("Euler", 30)):(val("error")):("Euler") with labels left offset 1,0.2 tc ls style("Euler"), \
     file("work") using (at("symplectic Euler", 30)):(val("error")):(NARROW ? "symplectic" : "symplectic Euler") with labels right offset -0.8,0.1 tc ls style("symplectic Euler"), \
     file("work") using (at("drag divided", 960)):(val("error")):("drag divided") with labels left offset 0.8,0.1 tc ls style("symplectic Euler, drag divided"), \
     file("work") using (at("velocity Verlet", 960)):(val("error")):(NARROW ? "Verlet" : "velocity Verlet") with labels left offset 0.8,0 tc ls style("velocity Verlet"), \
     file("work") using (at("RK4", 120)):(val("error")):("RK4") with labels right offset -1,-0.3 tc ls style("RK4"), \
     file("work-exact") using (exact_at(30)):(1e-9):("exact step") with labels left offset 0,0.8 tc ls EXACT
