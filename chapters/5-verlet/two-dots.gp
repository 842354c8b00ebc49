eval NARROW ? canvas(400, 340) : canvas(620, 430)
eval axis_names("x  [m]", "y  [m]")
set size ratio -1
set xrange [-0.2:3.4]
set yrange [-0.2:2.2]
set xtics 1
set ytics 1
# The path of the ball, and one step of a quarter of a second: the last displacement again, then h^2 a down.
X(n) = cell("two-dots", n + 1, "x")
Y(n) = cell("two-dots", n + 1, "y")
set parametric
set trange [0:0.8]
set arrow 1 from X(1),Y(1) to X(2),Y(2) nohead lc rgb "#000003" lw 1.6
set arrow 2 from X(2),Y(2) to X(3),2*Y(2)-Y(1) lc rgb "#000003" lw 1.6 dt (6,4) size 0.12,20
set arrow 3 from X(3),2*Y(2)-Y(1) to X(3),Y(3)+0.03 lc rgb "#000011" lw 1.8 size 0.12,20
set label 1 "{/:Italic x_{n–1}}" at X(1)+0.08,Y(1)-0.14 left
set label 2 "{/:Italic x_n}" at X(2)-0.05,Y(2)-0.16 left
set label 3 "{/:Italic x_{n+1}}" at X(3)-0.1,Y(3)-0.12 right
set label 4 "{/:Italic h^2 a}" at X(3)+0.08,1.35 left tc ls THIRD
set label 5 "the last step again" at X(2)+0.42,1.72 right tc ls VELOCITY_VERLET
plot 4*t, 5*t - 9.81*t*t/2 with lines ls EXACT, \
     file("two-dots") every ::2::4 using col("x"):col("y") with points ls VELOCITY_VERLET ps 1
