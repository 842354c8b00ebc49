eval NARROW ? canvas(400, 400) : canvas(720, 430)
set xlabel "evaluations per second of play, all six within a centimetre" offset 0,0.3
if (NARROW) set xlabel "evaluations per second of play" offset 0,0.3
set logscale x
set xrange [100:40000]
set yrange [13.6:-0.6]
set xtics ("100" 100, "300" 300, "1000" 1000, "3000" 3000, "10 000" 10000)
if (NARROW) set xtics ("100" 100, "1000" 1000, "10 000" 10000)
unset mxtics
unset ytics
set tmargin 1
set lmargin 2
set boxwidth 0.62
style(i) = i == 0 ? EULER : i == 1 ? SYMPLECTIC_EULER : i == 2 ? LEAPFROG : i == 3 ? STORMER_VERLET : i == 4 ? VELOCITY_VERLET : i == 5 ? YOSHIDA4 : i == 6 ? MIDPOINT : i == 7 ? HEUN : i == 8 ? RK4 : i == 9 ? DOPRI5 : i == 10 ? PREDICTED_EULER : i == 11 ? BACKWARD_EULER : TRAPEZOID
paid(i) = strcol(2) eq "inf" ? 40000 : $2
words = "%s: %s"
plot for [i=0:12] file("bills") every ::i+1::i+1 using (0):(i+1):(100):(strcol(2) eq "inf" ? 100 : $2):(i+0.7):(i+1.3) with boxxyerror ls style(i) dt solid fs transparent solid 0.35 noborder, \
     for [i=0:12] file("bills") every ::i+1::i+1 using (110):(i+1):(strcol(2) eq "inf" ? strcol(1).(NARROW ? ": not with 1024 steps" : ": not with 1024 steps a frame") : strcol(1).": ".strcol(2)) with labels left tc ls EXACT, \
     file("chosen") every ::1::1 using (0):(0):(100):1:(-0.3):(0.3) with boxxyerror ls EXACT dt solid fs transparent solid 0.35 noborder, \
     file("chosen") every ::1::1 using (110):(0):("chosen for each: ".strcol(1)) with labels left tc ls EXACT
