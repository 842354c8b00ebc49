eval NARROW ? canvas(400, 460) : canvas(720, 430)
set xlabel sprintf("largest error at %g steps a second  [cm]", exact("rate")) offset 0,0.3
set logscale x
set xrange [6e-4:2e5]
set yrange [0.4:6.6]
set lmargin NARROW ? 9 : 11
set tmargin NARROW ? 7.4 : 5
unset mxtics
set xtics ("< 10 µm" 0.001, "0.01" 0.01, "0.1" 0.1, "1" 1, "10" 10, "100" 100, "1000" 1000, "10^{4}" 1e4, "gone" 1e5)
if (NARROW) set xtics ("< 10 µm" 0.001, "0.1" 0.1, "1" 1, "10" 10, "1000" 1000, "gone" 1e5)
array things = ["jump", "leaf", "suspension", "hatch", "lamp", "shuttle"]
set ytics () scale 0
set for [j=1:6] ytics add (things[j] 7 - j)
unset key
array methods = ["Euler", "symplectic Euler", "velocity Verlet", "Yoshida 4", "midpoint", "RK4", "Dormand-Prince", "backward Euler", "trapezoid"]
gone(thing) = txt(thing) eq "inf"
error(i, j) = txt("method") ne methods[i] ? NaN : gone(things[j]) ? 1e5 : val(things[j]) < 1e-3 ? 1e-3 : val(things[j])
place(i, j) = 7 - j + 0.075*(5 - i)
tip(i, j) = sprintf("%s, %s: %s", methods[i], things[j], gone(things[j]) ? "gone" : sprintf("%.2g cm", val(things[j])))
across = NARROW ? 2 : 3
do for [i=1:9] {
  at = (i - 1) % across
  set label i methods[i] at graph (NARROW ? -0.05 : 0.02) + at*(NARROW ? 0.58 : 0.35), graph (NARROW ? 1.36 : 1.22) - 0.075*((i - 1)/across) \
    left offset 1,-0.2 point ls style(methods[i]) tc ls style(methods[i])
}
set arrow 1 from 1,0.4 to 1,6.6 nohead ls LIMIT
plot for [i=1:9] for [j=1:6] file("level") using (error(i, j)):(place(i, j)) with points ls style(methods[i]), \
     for [i=1:9] for [j=1:6] file("level") using (error(i, j)):(place(i, j)):(tip(i, j)) with labels hypertext point ls style(methods[i])
