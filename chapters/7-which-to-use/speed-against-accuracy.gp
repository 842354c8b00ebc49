eval NARROW ? canvas(400, 460) : canvas(720, 430)
set xlabel NARROW ? "time in a frame, for a thousand  [µs]" : "time in a frame, for a thousand suspensions  [µs]" offset 0,0.3
set ylabel "largest error" offset 0.5,0
set logscale xy
set xrange [0.8:300]
set yrange [2e-10:3]
set ytics ("1 nm" 1e-9, "1 µm" 1e-6, "1 mm" 1e-3, "1 m" 1)
set lmargin NARROW ? 8 : 9
set tmargin NARROW ? 6 : 4
array methods = ["Euler", "symplectic Euler", "velocity Verlet", "Yoshida 4", "midpoint", "RK4", "Dormand-Prince", "trapezoid", "backward Euler"]
across = NARROW ? 2 : 3
do for [i=1:9] {
  at = (i - 1) % across
  set label i methods[i] at graph (NARROW ? -0.05 : 0.02) + at*(NARROW ? 0.58 : 0.35), graph (NARROW ? 1.36 : 1.22) - 0.075*((i - 1)/across) \
    left offset 1,-0.2 point ls style(methods[i]) tc ls style(methods[i])
}
set arrow 1 from graph 0,first 0.01 to graph 1,first 0.01 nohead ls LIMIT
here(i) = txt("thing") eq "suspension" && txt("method") eq methods[i] && val("steps per second") >= exact("rate")
paid(i) = here(i) ? val("microseconds")*1000/exact("rate") : NaN
tip(i) = here(i) ? sprintf("%s, %d steps a frame: %.2g m", methods[i], val("steps per second")/exact("rate"), val("error")) : ""
plot for [i=1:9] file("work") using (paid(i)):(val("error")) with linespoints ls style(methods[i]), \
     for [i=1:9] file("work") using (paid(i)):(val("error")):(tip(i)) with labels hypertext point ls style(methods[i])
