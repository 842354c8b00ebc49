eval NARROW ? canvas(400, 850) : canvas(720, 440)
columns = NARROW ? 2 : 4
rows = NARROW ? 4 : 2
array methods = ["Euler", "midpoint", "Heun", "RK4", "backward Euler", "predicted Euler", "velocity Verlet", "symplectic Euler"]
array files = ["race-euler", "race-midpoint", "race-heun", "race-rk4", "race-backward-euler", "race-predicted-euler", "race-verlet", "race-symplectic-euler"]
array fates = ["flies off", "grows and turns", "grows and turns", "sinks", "crashes", "crashes", "holds and turns", "holds and turns"]
set xrange [-18:12]
set yrange [-14:14]
set size ratio -1
unset border
unset tics
unset grid
set parametric
set trange [0:2*pi]
set object 1 circle at 0,0 size 2 fillstyle solid noborder fillcolor rgb "#000009"
set multiplot
do for [i=1:8] {
  across = (i - 1)%columns
  row = (i - 1)/columns
  method = methods[i]
  fate = fates[i]
  set lmargin at screen (across + 0.02)/columns
  set rmargin at screen (across + 0.98)/columns
  set tmargin at screen 1 - real(row)/rows - 46.0/HEIGHT
  set bmargin at screen 1 - (row + 1.0)/rows + 6.0/HEIGHT
  set label 1 (method eq "velocity Verlet" ? "Verlet" : method) at graph 0.5,1.0 center offset 0,1.55
  set label 2 fate at graph 0.5,1.0 center offset 0,0.55 font ",13" tc ls EXACT
  # Who has left or crashed has no last turn; where there are few turns, each is drawn like a last one.
  from = fate eq "flies off" || fate eq "crashes" ? 0 : 152
  # Euler's shuttle comes back much later, from far outside.
  until = method eq "Euler" ? 4 : 1000
  plot 10*cos(t) - 5, 10*sqrt(0.75)*sin(t) with lines ls EXACT, \
       file(files[i]) using (val("t") < until ? val("x") : NaN):col("y") with lines ls style(method) lw 0.5 dt solid, \
       file(files[i]) using (method eq "Heun" || val("t") > from && val("t") < until ? val("x") : NaN):col("y") with lines ls style(method) lw (method eq "Heun" ? 0.5 : 1.8) dt solid, \
       "+" every 1000 using (5):(0) with points ls EXACT pt 7 ps 0.45
}
unset multiplot
