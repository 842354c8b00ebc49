eval NARROW ? canvas(400, 1040) : canvas(720, 1180)
# Six rows of two panels, each one unit wide and one high: on the left against evaluations, on the right against time.
array things = ["jump", "leaf", "suspension", "hatch", "lamp", "shuttle"]
array prices = ["evaluations", "microseconds"]
array cheapest = [25, 0.01]
array dearest = [7000, 60]
finest = 1e-9
coarsest = 10
gap = NARROW ? 0.08 : 0.06
share(value, low, high) = (log(value) - log(low))/(log(high) - log(low))
inside(value) = value < 0 ? NaN : value > 1 ? NaN : value
left(k) = (k - 1)*(1 + gap)
low(j) = (6 - j)*1.28
px(k, price) = left(k) + inside(share(price, cheapest[k], dearest[k]))
py(j, error) = low(j) + inside(share(error, finest, coarsest))
set xrange [-0.005:2 + gap + 0.005]
set yrange [-0.3:6*1.28]
unset border
unset tics
unset grid
set lmargin NARROW ? 6.5 : 7
set rmargin 1
set tmargin 0.6
set bmargin 0.2
SMALL = NARROW ? "Book Sans,11" : "Book Sans,13"
array errors = [1e-9, 1e-6, 1e-3, 1]
metres(e) = e < 1e-7 ? sprintf("%g nm", 1e9*e) : e < 1e-4 ? sprintf("%g µm", 1e6*e) : e < 0.1 ? sprintf("%g mm", 1e3*e) : sprintf("%g m", e)
array ticks = [30, 300, 3000, 0.1, 1, 10]
tick(k, price) = sprintf(k == 1 ? "%g" : "%g µs", price)
set label 1 NARROW ? "evaluations a second" : "evaluations per second of play" at left(1),low(1)+1.1 left font SMALL tc ls EXACT
set label 2 sprintf(NARROW ? "time, one of %s" : "time per second of play, one of %s", number("at-once")) at left(2),low(1)+1.1 left font SMALL tc ls EXACT
n = 2
do for [j=1:6] {
  n = n + 1
  set label n things[j] at left(1)+0.98,low(j)+0.86 right font "Book Sans Bold" tc ls EXACT
  do for [k=1:2] {
    PANELS = PANELS.panel(left(k), left(k) + 1, low(j), low(j) + 1, cheapest[k], dearest[k], finest, coarsest)
    n = n + 1
    set object n rectangle from left(k),low(j) to left(k)+1,low(j)+1 fs empty border lc rgb "#000009"
    set arrow n from left(k),py(j, 0.01) to left(k)+1,py(j, 0.01) nohead ls LIMIT
    do for [i=1:3] {
      n = n + 1
      set label n tick(k, ticks[3*(k - 1) + i]) at px(k, ticks[3*(k - 1) + i]),low(j)-0.11 center tc ls EXACT
    }
  }
  do for [i=1:4] {
    n = n + 1
    set label n metres(errors[i]) at -0.02,py(j, errors[i]) right tc ls EXACT
  }
}
look(m) = m eq "drag divided" || m eq "drag exact" ? style("symplectic Euler, drag divided") : m eq "soft constraint" ? style("backward Euler on a spring") : style(m)
all(j, k) = names_with("work", "method", "thing", things[j], prices[k])
at(j, k, m) = txt("thing") eq things[j] && txt("method") eq m ? px(k, val(prices[k])) : NaN
tip(j) = txt("thing") eq things[j] ? sprintf("%s, %d steps a second: %.2g m", txt("method"), val("steps per second"), val("error")) : ""
short(i) = txt("method") eq "velocity Verlet" ? "Verlet" : txt("method") eq "Yoshida 4" ? "Yoshida" : txt("method")
# What the answers call a panel: "leaf by evaluations".
row(p) = sum [j=1:6] (word(p, 1) eq things[j])*j
side_of(p) = word(p, 3) eq prices[1] ? 1 : 2
answer(p, is) = txt("panel") eq p && is ? px(side_of(p), val("price")) : NaN
height(p) = py(row(p), val("error"))
panels = names("work-answers", "panel", "changes left", "1")
# From the top down, in the order of their prices.
named(p, m) = txt("panel") eq p && txt("method") eq m && val("changes left") > 0 ? left(side_of(p)) + 0.02 : NaN
# Dormand-Prince has RK4's colour, so its pieces are dashed; each begins with a dot.
KIN = "Dormand-Prince"
dashed = names("work-answers", "panel", "method", KIN)
solid(p) = (file("work-answers"), names_if("work-answers", "method", sprintf("$%d == \"%s\" && $%d != \"%s\"", col("panel"), p, col("method"), KIN)))
best(p) = names("work-answers", "method", "panel", p)
place(t) = sum [j=1:6] (t eq things[j])*j
exact_things = names("work-exact", "thing", "steps per second", "60")
exact_at(t, k) = txt("thing") eq t ? px(k, val(prices[k])) : NaN
exact_tip(t) = txt("thing") eq t ? sprintf("exact step by %s, %d steps a second", txt("function"), val("steps per second")) : ""
steps_of(t) = names("work-exact", "function", "thing", t)
by(t, k, f) = txt("function") eq f ? exact_at(t, k) : NaN
plot for [k=1:2] for [t in exact_things] for [f in steps_of(t)] file("work-exact") using (by(t, k, f)):(py(place(t), finest)) with linespoints ls EXACT lw 3 dt solid pt 7 ps 0.5, \
     for [k=1:2] for [t in exact_things] file("work-exact") using (exact_at(t, k)):(py(place(t), finest)):(exact_tip(t)) with labels hypertext point ls EXACT ps 0.3, \
     for [k=1:2] for [j=1:6] for [m in all(j, k)] file("work") using (at(j, k, m)):(py(j, val("error"))) with lines ls CONTEXT, \
     for [k=1:2] for [j=1:6] file("work") using (txt("thing") eq things[j] ? px(k, val(prices[k])) : NaN):(py(j, val("error"))):(tip(j)) with labels hypertext point ls CONTEXT ps 0.3, \
     for [p in panels] for [m in solid(p)] file("work-answers") using (answer(p, txt("method") eq m)):(height(p)) with linespoints ls look(m) lw 4 dt solid pt 7 ps 0.35, \
     for [p in dashed] file("work-answers") using (answer(p, txt("method") eq KIN)):(height(p)) with lines ls look(KIN) lw 4 dt (3,6), \
     for [p in dashed] file("work-answers") using (answer(p, txt("method") eq KIN && val("changes left") > 0)):(height(p)) with points ls look(KIN) pt 7 ps 0.4, \
     for [p in panels] for [m in best(p)] file("work-answers") using (named(p, m)):(low(row(p)) + 0.13*val("changes left") - 0.04):(short(0)) with labels left font SMALL tc ls look(m)
