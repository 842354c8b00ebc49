eval NARROW ? canvas(400, 430) : canvas(720, 250)
unset border
unset tics
unset grid
set size ratio -1
set lmargin 1
set rmargin 1
set tmargin 1
set bmargin 1
wide = 125
x0(n) = NARROW ? (n % 2)*wide : n*wide
y0(n) = NARROW ? (n < 2 ? 0 : 135) : 0
set xrange [-4:(NARROW ? 2 : 4)*wide - 10]
set yrange [(NARROW ? 265 : 132):-4]
array what = ["chain", "rope", "cloth", "factor of the cloth"]
do for [n=0:3] {
  set object n + 1 rectangle from x0(n) - 2,y0(n) - 2 to x0(n) + 110,y0(n) + 110 lw 0.6 fs empty border lc rgb "#000009"
  set label n + 1 what[n + 1] at x0(n) + 54,y0(n) + 121 center tc ls EXACT
}
dot = NARROW ? 0.16 : 0.17
plot file("chain") using (x0(0) + val("column")):(y0(0) + val("row")) with points ls FIRST ps dot, \
     file("rope") using (x0(1) + val("column")):(y0(1) + val("row")) with points ls SECOND pt 7 ps dot, \
     file("cloth") using (x0(2) + val("column")):(y0(2) + val("row")) with points ls THIRD pt 7 ps dot, \
     file("factor") using (x0(3) + val("column")):(y0(3) + val("row")) with points ls THIRD pt 7 ps dot
