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
array methods = ["Euler", "midpoint", "RK4", "Dormand-Prince", "symplectic Euler", "drag divided", "velocity Verlet", "Yoshida 4", "predicted Euler", "trapezoid", "backward Euler", "exact step"]
look(m) = m eq "drag divided" ? SYMPLECTIC_EULER : m eq "exact step" ? EXACT : style(m)
do for [k=0:11] {
  set object k+1 rectangle from left(k),low(k) to left(k)+4,low(k)+2 fs empty border lc rgb "#000009"
  set label k+1 methods[k+1] at left(k),low(k)+2.25 left font NARROW ? "Book Sans,12" : "Book Sans,15" tc ls look(methods[k+1])
}
do for [k=12-across:11] {
  set label 20+k "0" at left(k),low(k)-0.24 left tc ls EXACT
  set label 40+k "{/:Italic hω}" at left(k)+2,low(k)-0.24 center tc ls EXACT
  set label 60+k "4" at left(k)+4,low(k)-0.24 right tc ls EXACT
}
do for [r=0:down-1] {
  k = r*across
  set label 80+r "{/:Italic ζ}" at left(k)-0.38,low(k)+1 left tc ls EXACT
  set label 100+r "0" at left(k)-0.38,low(k)+0.12 left tc ls EXACT
  set label 120+r "2" at left(k)-0.38,low(k)+1.88 left tc ls EXACT
}
stable(k) = val(methods[k+1])
true(k) = val(methods[k+1]." true")
tip(k) = sprintf("%s, ζ = %.2f: stable to hω = %.2f, true to %.2f", methods[k+1], val("ζ"), stable(k), true(k))
limit(k) = stable(k) < 4 ? left(k) + stable(k) : NaN  # the edge is no limit, and the last three have none
plot for [k=0:11] file("map") using (left(k)+stable(k)):(low(k)+val("ζ")) with filledcurves x1=left(k) ls look(methods[k+1]) fs transparent solid 0.22 noborder, \
     for [k=0:11] file("map") using (left(k)+true(k)):(low(k)+val("ζ")) with filledcurves x1=left(k) ls look(methods[k+1]) fs transparent solid 0.6 noborder, \
     for [k=0:8] file("map") using (limit(k)):(low(k)+val("ζ")) with lines ls look(methods[k+1]) lw 1.2 dt solid, \
     for [k=0:11] file("map") every 5 using (left(k)+stable(k)):(low(k)+val("ζ")):(tip(k)) with labels hypertext point ls look(methods[k+1]) ps 0.3
