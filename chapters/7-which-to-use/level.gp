eval NARROW ? canvas(400, 460) : canvas(720, 430)
set xlabel "largest error at 60 steps a second  [cm]" offset 0,0.3
set logscale x
set xrange [6e-4:2e5]
set yrange [0.4:6.6]
set lmargin NARROW ? 9 : 11
set tmargin NARROW ? 7.4 : 5
unset mxtics
set xtics ("< 10 µm" 0.001, "0.01" 0.01, "0.1" 0.1, "1" 1, "10" 10, "100" 100, "1000" 1000, "10^{4}" 1e4, "gone" 1e5)
if (NARROW) set xtics ("< 10 µm" 0.001, "0.1" 0.1, "1" 1, "10" 10, "1000" 1000, "gone" 1e5)
set ytics ("jump" 6, "leaf" 5, "suspension" 4, "hatch" 3, "lamp" 2, "shuttle" 1) scale 0
unset key
clip(j) = strcol(j) eq "inf" ? 1e5 : column(j) < 1e-3 ? 1e-3 : column(j)
row(i) = 1 + int(word("0 1 4 5 6 8 9 11 12", i))
place(i, j) = 8 - j + 0.075*(5 - i)
style(i) = i == 1 ? EULER : i == 2 ? SYMPLECTIC_EULER : i == 3 ? VELOCITY_VERLET : i == 4 ? YOSHIDA4 : i == 5 ? MIDPOINT : i == 6 ? RK4 : i == 7 ? DOPRI5 : i == 8 ? BACKWARD_EULER : TRAPEZOID
name(i) = word("Euler symplectic_Euler velocity_Verlet Yoshida_4 midpoint RK4 Dormand-Prince backward_Euler trapezoid", i)
plain(i) = i == 2 ? "symplectic Euler" : i == 3 ? "velocity Verlet" : i == 4 ? "Yoshida 4" : i == 8 ? "backward Euler" : name(i)
thing(j) = word("x jump leaf suspension hatch lamp shuttle", j)
across = NARROW ? 2 : 3
do for [i=1:9] {
  at = (i - 1) % across
  set label i plain(i) at graph (NARROW ? -0.05 : 0.02) + at*(NARROW ? 0.58 : 0.35), graph (NARROW ? 1.36 : 1.22) - 0.075*((i - 1)/across) \
    left offset 1,-0.2 point ls style(i) tc ls style(i)
}
set arrow 1 from 1,0.4 to 1,6.6 nohead ls LIMIT
plot for [i=1:9] for [j=2:7] file("level") every ::row(i)::row(i) using (clip(j)):(place(i, j)) with points ls style(i) notitle, \
     for [i=1:9] for [j=2:7] file("level") every ::row(i)::row(i) using (clip(j)):(place(i, j)):(sprintf("%s, %s: %s", plain(i), thing(j), strcol(j) eq "inf" ? "gone" : sprintf("%.2g cm", column(j)))) with labels hypertext point ls style(i) notitle
