eval NARROW ? canvas(400, 420) : canvas(720, 420)
set xlabel NARROW ? "evaluations per second of play" : "evaluations per second of play, all six within a centimetre" offset 0,0.3
set logscale x
set xrange [250:NARROW ? 66000 : 40000]
set yrange [14.6:0.4]
never = NARROW ? 44000 : 24000
set xtics ("300" 300, "1000" 1000, "3000" 3000, "10 000" 10000, "never" never)
if (NARROW) set xtics ("300" 300, "1000" 1000, "3000" 3000, "never" never)
unset mxtics
set ytics scale 0
set grid xtics ytics back ls GRID
set lmargin NARROW ? 15.5 : 16
set tmargin 1
edge = NARROW ? 30000 : 15000
set arrow 1 from edge,0.4 to edge,14.6 nohead ls LIMIT
methods = "Euler symplectic_Euler leapfrog Störmer–Verlet velocity_Verlet Yoshida_4 midpoint Heun RK4 Dormand-Prince predicted_Euler backward_Euler trapezoid"
styles = "EULER SYMPLECTIC_EULER LEAPFROG STORMER_VERLET VELOCITY_VERLET YOSHIDA4 MIDPOINT HEUN RK4 DOPRI5 PREDICTED_EULER BACKWARD_EULER TRAPEZOID"
spaced(name) = (cut = strstrt(name, "_"), cut ? name[1:cut - 1]." ".name[cut + 1:*] : name)
paid(n) = strcol(n) eq "inf" ? never : column(n)
plot file("bills") every ::1 using (paid(2)):($0 + 1):ytic(1) with points ls EXACT ps 0, \
     file("bills") every ::1::1 using (paid(2)):($0 + 1) with points ls EXACT pt 7 ps 0.8, \
     for [i=1:words(methods)] file("bills") every ::1 using (strcol(1) eq spaced(word(methods, i)) ? paid(2) : NaN):($0 + 1) with points ls value(word(styles, i)), \
     file("bills") every ::1 using (paid(2)):($0 + 1):(strcol(2) eq "inf" ? "" : strcol(2)) with labels left offset 0.9,0 tc ls EXACT
