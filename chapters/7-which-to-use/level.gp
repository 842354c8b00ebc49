eval NARROW ? canvas(400, 450) : canvas(720, 430)
unset border
unset tics
unset grid
unset key
array things = ["jump", "leaf", "suspension", "hatch", "lamp", "shuttle"]
array methods = ["Euler", "symplectic Euler", "backward Euler", "trapezoid", "BDF2", "midpoint", "velocity Verlet", "Yoshida 4", "RK4", "Dormand-Prince"]
set xrange [NARROW ? -2.55 : -1.75:6.1]
set yrange [10.6:(NARROW ? -1.2 : -0.9)]
set lmargin 0
set rmargin 0
set tmargin 0
set bmargin 0
small = NARROW ? "Book Sans,11" : "Book Sans,15"
do for [j=1:6] { set label j things[j] at j - 0.5,NARROW && j % 2 ? -0.8 : -0.35 center font small tc ls EXACT }
do for [i=1:10] { set label 10 + i methods[i] at -0.15,i - 0.5 right font small tc ls style(methods[i]) }
here(i) = txt("method") eq methods[i]
gone(j) = txt(things[j]) eq "inf"
error(j) = gone(j) ? 1e9 : val(things[j])  # [cm]
finest = 10  # [µm]
misses(j) = error(j) > 1
two(x, unit) = sprintf(x < 9.95 ? "%.1f %s" : "%.0f %s", x, unit)
amount(j) = gone(j) ? "gone" : error(j) < 1e-4*finest ? sprintf("< %g µm", finest) : error(j) < 0.1 ? two(1e4*error(j), "µm") : error(j) < 1 ? two(10*error(j), "mm") : error(j) < 100 ? two(error(j), "cm") : two(error(j)/100, "m")
# Where a cell stands; out of sight if it is not one that misses.
shown(i, j) = here(i) && misses(j) ? j - 0.5 : -100
set style fill solid noborder
plot for [i=1:10] for [j=1:6] file("level") using (shown(i, j)):(i - 0.5):(shown(i, j) - 0.48):(shown(i, j) + 0.48):(i - 0.96):(i - 0.04) with boxxyerror ls AREA, \
     for [i=1:10] for [j=1:6] file("level") using (shown(i, j)):(i - 0.5):(amount(j)) with labels font small tc ls LIMIT, \
     for [i=1:10] for [j=1:6] file("level") using (here(i) && !misses(j) ? j - 0.5 : -100):(i - 0.5):(amount(j)) with labels font small tc ls EXACT
