eval NARROW ? canvas(400, 400) : canvas(600, 560)
eval axis_names("stretch", "velocity over ω")
set size ratio -1
set xrange [-0.6:1.3]
set yrange [-1.65:0.12]
set xtics 0.5
set ytics 0.5
set parametric
set trange [-0.2:1.9]
x(row) = cell("arrow", row, "stretch")
y(row) = cell("arrow", row, "velocity")
set arrow 1 from 0,0 to x(1),y(1) ls CONTEXT lw 1.6 filled size 0.05,20
set arrow 2 from 0,0 to x(5),y(5) ls RK4 filled size 0.05,20
set arrow 3 from 0,0 to x(6),y(6) ls EXACT filled size 0.05,20
set arrow 4 from x(1),y(1) to x(2),y(2) ls EULER lw 1.6 filled size 0.04,20
set arrow 5 from x(2),y(2) to x(3),y(3) ls MIDPOINT lw 1.6 filled size 0.04,20
set arrow 6 from x(3),y(3) to x(4),y(4) ls RK4 lw 1.2 filled size 0.04,20
set arrow 7 from x(4),y(4) to x(5),y(5) ls RK4 lw 1.2 filled size 0.04,20
set label 1 "before" at 0.5,0.05 center tc ls EXACT
set label 2 "{/:Italic h}ω" at 1.03,-0.75 left tc ls EULER
set label 3 "({/:Italic h}ω)²/2" at 0.45,-1.57 center tc ls MIDPOINT
set label 4 "({/:Italic h}ω)³/6" at -0.15,-1.22 right tc ls RK4
set label 5 "({/:Italic h}ω)⁴/24" at -0.1,-0.87 right tc ls RK4
if (NARROW) set label 5 "" at 0,0
set label 6 "Euler" at 1.04,-1.5 left tc ls EULER
set label 7 "midpoint" at -0.16,-1.56 right tc ls MIDPOINT
if (NARROW) set label 7 "mid" at -0.15,-1.56
set label 8 "RK4" at 0.11,-0.88 left tc ls RK4
set label 9 "true" at 0.1,-1.05 left tc ls EXACT
plot cos(t), -sin(t) with lines ls EXACT, \
     file("arrow") every ::2::2 using col("stretch"):col("velocity") with points ls EULER, \
     file("arrow") every ::3::3 using col("stretch"):col("velocity") with points ls MIDPOINT, \
     file("arrow") every ::5::5 using col("stretch"):col("velocity") with points ls RK4, \
     file("arrow") every ::2::5 using col("stretch"):col("velocity"):(sprintf("length %.3f", sqrt(val("stretch")**2 + val("velocity")**2))) with labels hypertext point ls RK4 ps 0.4
