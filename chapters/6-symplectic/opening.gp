eval NARROW ? canvas(400, 400) : canvas(640, 640)
unset border
unset tics
unset grid
unset key
set size ratio -1
set lmargin 0
set rmargin 0
set tmargin 0
set bmargin 0
set parametric
set trange [0:2*pi]
# Four panels, each 94 cm wide and high, of the plane of stretch and velocity over ω.
array k = [0.67, 1.5, 1.9, 2.1]
x0(i) = (i - 1) % 2
y0(i) = i > 2 ? -1 : 0
set xrange [-0.52:1.52]
set yrange [-1.52:0.52]
# The shadow ellipse x^2 - k x u + u^2 = x0^2, k = h omega, along its two axes; a hyperbola from k = 2 on.
far(k) = 0.1/sqrt(2 - k)
near(k) = 0.1/sqrt(2 + k)
swing(i) = sprintf("opening-%.0f", 100*k[i])
do for [i=1:4] {
  set object i rectangle from x0(i) - 0.47,y0(i) - 0.47 to x0(i) + 0.47,y0(i) + 0.47 lw 0.6 fs empty border lc rgb "#000009"
  set arrow i from x0(i) - 0.47,y0(i) to x0(i) + 0.47,y0(i) nohead ls GRID
  set arrow 10 + i from x0(i),y0(i) - 0.47 to x0(i),y0(i) + 0.47 nohead ls GRID
  set label i sprintf("{/:Italic hω} = %g", k[i]) at x0(i) - 0.43,y0(i) + 0.4 left tc ls (i < 4 ? SYMPLECTIC_EULER : LIMIT)
}
along(t) = 0.94*(t/(2*pi) - 0.5)
bend(p) = near(k[4])*sqrt(1 + 10*p*p)
within(p) = abs(p) < 0.47 ? p : NaN
u(i) = val("v")/20
inside(i) = abs(val("x")) < 0.47 && abs(u(i)) < 0.47
# A number stands a little farther out than its point.
out(i) = 1 + 0.065/sqrt(val("x")**2 + u(i)**2)
plot for [i=1:3] x0(i) + far(k[i])*cos(t) - near(k[i])*sin(t), y0(i) + far(k[i])*cos(t) + near(k[i])*sin(t) with lines ls CONTEXT, \
     for [side in "1 -1"] x0(4) + within(along(t) + side*bend(along(t))), y0(4) + within(along(t) - side*bend(along(t))) with lines ls LIMIT, \
     for [i=1:3] file(swing(i)) using (x0(i) + val("x")):(y0(i) + u(i)) with points ls SYMPLECTIC_EULER ps 0.35, \
     for [i=1:4] file(swing(i)) every ::1::3 using (inside(i) ? x0(i) + val("x") : NaN):(y0(i) + u(i)) with points ls (i < 4 ? SYMPLECTIC_EULER : LIMIT) pt 7 ps 0.8, \
     for [i=1:4] file(swing(i)) every ::1::3 using (inside(i) ? x0(i) + out(i)*val("x") : NaN):(y0(i) + out(i)*u(i)):(sprintf("%d", $0 + 1)) with labels tc ls (i < 4 ? SYMPLECTIC_EULER : LIMIT)
