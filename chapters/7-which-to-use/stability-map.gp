eval NARROW ? canvas(400, 560) : canvas(720, 520)
across = NARROW ? 3 : 4
down = 12/across
set xrange [-0.5:across*4.75]
set yrange [-0.75:down*2.85]
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
  set label 40+k "{/:Italic h}ω" at left(k)+2,low(k)-0.24 center tc rgb "#000007"
  set label 60+k "4" at left(k)+4,low(k)-0.24 right tc rgb "#000007"
}
do for [r=0:down-1] {
  k = r*across
  set label 80+r "ζ" at left(k)-0.38,low(k)+1 left tc rgb "#000007"
  set label 100+r "0" at left(k)-0.38,low(k)+0.12 left tc rgb "#000007"
  set label 120+r "2" at left(k)-0.38,low(k)+1.88 left tc rgb "#000007"
}
tip = "%s, ζ = %.2f: stable to hω = %.2f, true to %.2f"
limit(k) = column(2*k+2) < 4 ? left(k) + column(2*k+2) : NaN  # the edge is no limit, and the last three have none
plot for [k=0:11] file("map") using (left(k)+column(2*k+2)):(low(k)+$1) with filledcurves x1=left(k) ls style(k) fs transparent solid 0.22 noborder, \
     for [k=0:11] file("map") using (left(k)+column(2*k+3)):(low(k)+$1) with filledcurves x1=left(k) ls style(k) fs transparent solid 0.6 noborder, \
     for [k=0:8] file("map") using (limit(k)):(low(k)+$1) with lines ls style(k) lw 1.2 dt solid, \
     for [k=0:11] file("map") every 5 using (left(k)+column(2*k+2)):(low(k)+$1):(sprintf(tip, plain(k), $1, column(2*k+2), column(2*k+3))) with labels hypertext point ls style(k) ps 0.3
