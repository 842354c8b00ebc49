eval NARROW ? canvas(400, 430) : canvas(720, 430)
eval axis_names(NARROW ? "the step, as {/:Italic hω}" : "the step, as {/:Italic hω}: left of its line a method is stable, right of it explodes", NARROW ? "damping, as {/:Italic ζ}" : "the damping, as {/:Italic ζ}: critical at one")
set xrange [0:4]
set yrange [0:2.15]
set xtics 1
set ytics 0.5
set lmargin NARROW ? 5 : 6
set rmargin 3
set label 1 NARROW ? "Verlet" : "velocity Verlet" at 0.13,1.3 rotate by 90 center tc ls style("velocity Verlet")
array methods = ["Euler", "symplectic Euler", "drag divided", "velocity Verlet", "RK4"]
look(m) = m eq "drag divided" ? style("symplectic Euler, drag divided") : style(m)
limit(m) = val(m) < 4 ? val(m) : NaN  # the edge is no limit
tip(m) = sprintf("%s, ζ = %.2f: stable to hω = %.2f", m, val("ζ"), val(m))
at(m, zeta) = abs(val("ζ") - zeta) < 1e-9 ? val(m) : NaN
dot_tip(i) = sprintf("%s at %s: hω = %.2f, ζ = %.1f", txt("thing"), number("rate"), val("hω"), val("ζ"))
plot for [i=1:5] file("map") using (limit(methods[i])):(val("ζ")) with lines ls look(methods[i]), \
     for [i=1:5] file("map") every 5 using (limit(methods[i])):(val("ζ")):(tip(methods[i])) with labels hypertext point ls look(methods[i]) ps 0.4, \
     file("map") using (at("Euler", 1)):(val("ζ")):("Euler") with labels left offset 0.8,-0.3 tc ls style("Euler"), \
     file("map") using (at("symplectic Euler", 0.28)):(val("ζ")):(NARROW ? "symplectic" : "symplectic Euler") with labels left offset 0.8,0.2 tc ls style("symplectic Euler"), \
     file("map") using (at("drag divided", 0.6)):(val("ζ")):(NARROW ? "divided" : "drag divided") with labels right offset (NARROW ? 3 : -1.5),0.9 tc ls style("symplectic Euler, drag divided"), \
     file("map") using (at("RK4", 1.2)):(val("ζ")):("RK4") with labels left offset 0.8,0.5 tc ls style("RK4"), \
     file("springs-at-sixty") using (val("hω")):(val("ζ")) with points ls EXACT pt 7 ps 0.9, \
     file("springs-at-sixty") using (val("hω")):(val("ζ")):(txt("thing")) with labels left offset 0.9,-0.1 tc ls EXACT, \
     file("springs-at-sixty") using (val("hω")):(val("ζ")):(dot_tip(0)) with labels hypertext point ls EXACT pt 7 ps 0.9
