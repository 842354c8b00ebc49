eval NARROW ? canvas(400, 760) : canvas(720, 380)
unset border
unset tics
unset grid
set size ratio -1
set lmargin 0
set rmargin 0
set tmargin 0
set bmargin 0
# A field for each method and orbit: side by side, and two by two on a phone.
side = 34
wide = 33
left(n, orbit) = NARROW ? (n % 2)*side : n*side
top(n, orbit) = NARROW ? -(2*orbit + n/2)*side : -orbit*side
set xrange [-wide/2. - 1:(NARROW ? 2 : 4)*side - wide/2.]
set yrange [-((NARROW ? 4 : 2)*side - wide/2.):wide/2. + 1]
array methods = ["Euler", "symplectic Euler", "midpoint", "RK4"]
array files = ["equal-euler", "equal-symplectic", "equal-midpoint", "equal-rk4"]
array orbits = ["circle", "ellipse"]
do for [orbit=0:1] {
  do for [n=0:3] {
    i = 1 + n + 4*orbit
    set object i rectangle center left(n, orbit),top(n, orbit) size wide,wide lw 0.6 fs empty border lc rgb "#000009"
    set label i methods[n + 1] at left(n, orbit) - wide/2. + 1,top(n, orbit) + (1 - 2*orbit)*(wide/2. - 2.2) left tc ls style(methods[n + 1])
  }
}
# The tower of the ellipse stands where the ellipse lies in the middle.
tower(orbit) = 6*orbit
x(n, orbit, value) = left(n, orbit) + tower(orbit) + value
y(n, orbit, value) = top(n, orbit) + value
across(orbit) = val(orbits[orbit + 1]." x")
up(orbit) = val(orbits[orbit + 1]." y")
inside(orbit) = abs(across(orbit) + tower(orbit)) < wide/2. && abs(up(orbit)) < wide/2.
set parametric
set trange [0:2*pi]
plot for [i=0:7] left(i % 4, i/4) + 10*cos(t), top(i % 4, i/4) + (i < 4 ? 10 : 8)*sin(t) with lines ls EXACT lw 0.9, \
     for [i=0:7] file(files[i % 4 + 1]) using (inside(i/4) ? x(i % 4, i/4, across(i/4)) : NaN):(y(i % 4, i/4, up(i/4))) \
       with lines ls style(methods[i % 4 + 1]) lw 1.3 dt solid, \
     for [i=0:7] "+" every 1000 using (x(i % 4, i/4, 0)):(y(i % 4, i/4, 0)) with points ls CONTEXT pt 7 ps 0.5
