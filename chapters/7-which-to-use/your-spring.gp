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
style(k) = k == 0 ? EULER : k == 1 ? MIDPOINT : k == 2 ? RK4 : k == 3 ? DOPRI5 : k < 6 ? SYMPLECTIC_EULER : k == 6 ? VELOCITY_VERLET : k == 7 ? YOSHIDA4 : k == 8 ? PREDICTED_EULER : k == 9 ? TRAPEZOID : k == 10 ? BACKWARD_EULER : EXACT
name(k) = word("Euler midpoint RK4 Dormand-Prince symplectic_Euler drag_divided velocity_Verlet Yoshida_4 predicted_Euler trapezoid backward_Euler exact_step", k + 1)
plain(k) = k == 4 ? "symplectic Euler" : k == 5 ? "drag divided" : k == 6 ? "velocity Verlet" : k == 7 ? "Yoshida 4" : k == 8 ? "predicted Euler" : k == 10 ? "backward Euler" : k == 11 ? "exact step" : name(k)
colour(k) = k == 3 ? 4 : k == 4 || k == 5 ? 2 : k == 6 ? 3 : k == 7 ? 10 : k == 8 || k == 10 ? 5 : k == 9 ? 11 : k == 11 ? 7 : k == 1 ? 6 : k == 2 ? 4 : 1
do for [k=0:11] {
  set object k+1 rectangle from left(k),low(k) to left(k)+4,low(k)+2 fs empty border lc rgb "#000009"
  set label k+1 plain(k) at left(k),low(k)+2.25 left font NARROW ? "Book Sans,12" : "Book Sans,15" tc rgb sprintf("#%06x", colour(k))
}
do for [k=12-across:11] {
  set label 20+k "0" at left(k),low(k)-0.24 left tc rgb "#000007"
  set label 40+k "1 s" at left(k)+4,low(k)-0.24 right tc rgb "#000007"
}
most = 1.5  # of the stretch, one at the start; what leaves the panel ends at its edge
along(k) = left(k) + 4*$1
height(k, x) = low(k) + 1 + x/most
inside(x) = ($0 == 0 ? gone = 0 : 0, gone ? NaN : abs(x) > most ? (gone = 1, x > 0 ? most : -most) : x)
plot for [k=0:11] file("your-spring") using (along(k)):(height(k, 0)) with lines ls GRID, \
     for [k=0:11] file("your-spring") using (along(k)):(height(k, column(13))) with lines ls EXACT, \
     for [k=0:11] file("your-spring") using (along(k)):(height(k, inside(column(k+2)))) with linespoints ls style(k) dt solid pt 7 ps 0.25
