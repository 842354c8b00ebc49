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
# Each matrix is drawn as bars of entries that stand below one another. In a corner, nine rows and columns of the chain
# and of the rope are shown larger, entry by entry.
first = 3
zoomed = 9
scale = 5.5
do for [n=0:1] {
  set object 10 + n rectangle from x0(n) + first - 1,y0(n) + first - 1 to x0(n) + first + zoomed,y0(n) + first + zoomed lw 0.8 fs empty border lc rgb "#000007"
  set object 20 + n rectangle from x0(n) + 54,y0(n) + 4 to x0(n) + 104,y0(n) + 54 lw 0.8 fs empty border lc rgb "#000007"
  set arrow 1 + n from x0(n) + first + zoomed,y0(n) + first + 4 to x0(n) + 54,y0(n) + first + 4 nohead ls CONTEXT
}
within(from, k, to) = from <= k && k <= to
x(n) = x0(n) + val("column")
low(n) = y0(n) + val("from row")
high(n) = y0(n) + val("to row")
is_shown(k) = within(val("from row"), k, val("to row")) && within(first, val("column"), first + zoomed - 1)
across(n, k) = is_shown(k) ? x0(n) + 57 + scale*(val("column") - first) : NaN
down(n, k) = y0(n) + 7 + scale*(k - first)
plot for [n=0:0] file("chain") using (x(n)):(low(n)):(x(n) - .55):(x(n) + .55):(low(n) - .55):(high(n) + .55) with boxxyerror ls FIRST fs solid noborder, \
     for [n=1:1] file("rope") using (x(n)):(low(n)):(x(n) - .55):(x(n) + .55):(low(n) - .55):(high(n) + .55) with boxxyerror ls SECOND fs solid noborder, \
     for [n=2:2] file("cloth") using (x(n)):(low(n)):(x(n) - .55):(x(n) + .55):(low(n) - .55):(high(n) + .55) with boxxyerror ls THIRD fs solid noborder, \
     for [n=3:3] file("factor") using (x(n)):(low(n)):(x(n) - .55):(x(n) + .55):(low(n) - .55):(high(n) + .55) with boxxyerror ls THIRD fs solid noborder, \
     for [k=first:first + zoomed - 1] file("chain") using (across(0, k)):(down(0, k)):(across(0, k) - 2.3):(across(0, k) + 2.3):(down(0, k) - 2.3):(down(0, k) + 2.3) with boxxyerror ls FIRST fs solid noborder, \
     for [k=first:first + zoomed - 1] file("rope") using (across(1, k)):(down(1, k)):(across(1, k) - 2.3):(across(1, k) + 2.3):(down(1, k) - 2.3):(down(1, k) + 2.3) with boxxyerror ls SECOND fs solid noborder
