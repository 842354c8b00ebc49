eval NARROW ? canvas(400, 430) : canvas(720, 470)
eval axis_names("time per second of play, one of 512 shuttles  [µs]", "largest error in one turn  [m]")
set logscale xy
set xrange [NARROW ? 0.01 : 0.02:NARROW ? 200 : 30]
set xtics (0.1, 1, 10)
set yrange [1e-11:1000]
set ytics ("1 m" 1, "1 cm" 1e-2, "0.1 mm" 1e-4, "1 µm" 1e-6, "10 nm" 1e-8)
unset mxtics
unset mytics
set lmargin NARROW ? 7.5 : 8
at(i) = 1 + 4*int(word("0 1 4 5 6 8 9 11 12", i))
style(i) = i == 1 ? EULER : i == 2 ? SYMPLECTIC_EULER : i == 3 ? VELOCITY_VERLET : i == 4 ? YOSHIDA4 : i == 5 ? MIDPOINT : i == 6 ? RK4 : i == 7 ? DOPRI5 : i == 8 ? BACKWARD_EULER : TRAPEZOID
plot for [i=1:9] file("work-time") every ::at(i)::at(i)+3 using 3:4 with linespoints ls style(i), \
     for [i=1:9] file("work-time") every ::at(i)::at(i)+3 using 3:4:(sprintf("%s, %d steps a second: %.2g m", strcol(1), $2, $4)) with labels hypertext point ls style(i), \
     file("work-time") every ::at(1)+0::at(1)+0 using 3:4:(strcol(1)) with labels right offset -0.8,0.1 tc ls EULER, \
     file("work-time") every ::at(2)+0::at(2)+0 using 3:4:(NARROW ? "symplectic" : strcol(1)) with labels right offset -0.8,0.1 tc ls SYMPLECTIC_EULER, \
     file("work-time") every ::at(3)+0::at(3)+0 using 3:4:(NARROW ? "Verlet" : strcol(1)) with labels right offset -0.8,-0.6 tc ls VELOCITY_VERLET, \
     file("work-time") every ::at(4)+3::at(4)+3 using 3:4:("Yoshida") with labels left offset 0.8,0 tc ls YOSHIDA4, \
     file("work-time") every ::at(5)+3::at(5)+3 using 3:4:(strcol(1)) with labels left offset 0.6,-0.6 tc ls MIDPOINT, \
     file("work-time") every ::at(6)+3::at(6)+3 using 3:4:(strcol(1)) with labels left offset 0.8,0.2 tc ls RK4, \
     file("work-time") every ::at(7)+3::at(7)+3 using 3:4:(strcol(1)) with labels right offset -0.6,-0.35 tc ls DOPRI5, \
     file("work-time") every ::at(8)+3::at(8)+3 using 3:4:(strcol(1)) with labels left offset 0.8,0 tc ls BACKWARD_EULER, \
     file("work-time") every ::at(9)+3::at(9)+3 using 3:4:(strcol(1)) with labels left offset 0.8,0.2 tc ls TRAPEZOID
