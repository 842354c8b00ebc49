eval NARROW ? canvas(400, 560) : canvas(720, 520)
across = NARROW ? 3 : 4
down = 12/across
set xrange [-0.3:across*4.75]
set yrange [-0.45:down*2.85]
set lmargin 1
set rmargin 1
set tmargin 0.5
set bmargin 0.5
unset border
unset tics
unset grid
left(k) = 4.75*(k % across)
low(k) = 2.85*(down - 1 - k/across)
array methods = ["Euler", "midpoint", "RK4", "Dormand-Prince", "symplectic Euler", "drag divided", "velocity Verlet", "Yoshida 4", "predicted Euler", "trapezoid", "backward Euler", "exact step"]
look(m) = m eq "drag divided" ? SYMPLECTIC_EULER : m eq "exact step" ? EXACT : style(m)
do for [k=0:11] {
  set object k+1 rectangle from left(k),low(k) to left(k)+4,low(k)+2 fs empty border lc rgb "#000009"
  set label k+1 methods[k+1] at left(k),low(k)+2.25 left font NARROW ? "Book Sans,12" : "Book Sans,15" tc ls look(methods[k+1])
}
do for [k=12-across:11] {
  set label 20+k "0" at left(k),low(k)-0.24 left tc ls EXACT
  set label 40+k number("camera-watched") at left(k)+4,low(k)-0.24 right tc ls EXACT
}
most = 1.5  # of the stretch, one at the start; what leaves the panel ends at its edge
along(k) = left(k) + 4*val("t")/exact("camera-watched")
height(k, x) = low(k) + 1 + x/most
inside(x) = ($0 == 0 ? gone = 0 : 0, gone ? NaN : abs(x) > most ? (gone = 1, x > 0 ? most : -most) : x)
plot for [k=0:11] file("your-spring") using (along(k)):(height(k, 0)) with lines ls GRID, \
     for [k=0:11] file("your-spring") using (along(k)):(height(k, val("exact step"))) with lines ls EXACT, \
     for [k=0:11] file("your-spring") using (along(k)):(height(k, inside(val(methods[k+1])))) with linespoints ls look(methods[k+1]) dt solid pt 7 ps 0.25
