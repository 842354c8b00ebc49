# Three panels, one below the other: a row for each variant, a point for each of its times, and
# through the point a line from the shortest to the longest round.
eval canvas(WIDTH, HEIGHT)
set style line VELOCITY_VERLET lc rgb "#000003" lw 2.2 pt 9 ps 0.7
set style line RK4             lc rgb "#000004" lw 2.2 pt 13 ps 0.8

set multiplot
set lmargin at screen 0.4
set rmargin at screen 0.97
set border 1
set tics scale 0.6,0
set xtics offset 0,0.3
set ytics scale 0
set grid xtics ytics back ls GRID
set logscale x
set bars 0
y(pixels) = 1 - pixels/(1.0*HEIGHT)
head(text, top) = sprintf("unset label; set label 1 '%s' at screen 0.02,%g left", text, y(top))
key(n, text, x, top, look) = sprintf("set label %d '%s' at screen %g,%g left offset 0.8,-0.25 point %s", n, text, x, y(top), look)
panel(name, top, bottom) = sprintf("set tmargin at screen %g; set bmargin at screen %g; stats file('%s') using col('row') nooutput; set yrange [0.4:STATS_max + 0.6]", y(top), y(bottom), name)

# Its place, and not txt("variant"), which ends at a comma.
variant = (file("orbit"), col("variant"))
load DATA."machine.gp"
eval head("{/:Bold One orbit:} ns for a step, ".FLAGS, 20)
eval key(2, "euler", 0.05, 48, "ls EULER")
eval key(3, "symplectic\\_euler", 0.19, 48, "ls SYMPLECTIC_EULER")
eval key(4, "velocity\\_verlet", 0.45, 48, "ls VELOCITY_VERLET")
eval key(5, "rk4", 0.69, 48, "ls RK4")
eval panel("orbit", 64, 394)
set xrange [5:1000]
set xtics (5, 10, 20, 50, 100, 200, 500, 1000)
plot file("orbit") using col("rk4"):col("row"):col("rk4 from"):col("rk4 to") with xerrorbars ls RK4, \
     file("orbit") using col("euler"):col("row"):col("euler from"):col("euler to") with xerrorbars ls EULER, \
     file("orbit") using col("symplectic_euler"):(val("row") + 0.12):col("symplectic_euler from"):col("symplectic_euler to") with xerrorbars ls SYMPLECTIC_EULER, \
     file("orbit") using col("velocity_verlet"):(val("row") - 0.12):col("velocity_verlet from"):col("velocity_verlet to") with xerrorbars ls VELOCITY_VERLET, \
     file("orbit") every ::1 using (10):col("row"):(""):ytic(variant) with labels

eval head("{/:Bold Ten million particles:} speed in multiples of what memory allows, ".FLAGS, 458)
eval key(2, "float", 0.05, 486, "ls FIRST")
eval key(3, "float, two threads", 0.19, 486, "ls FIRST pt 6")
eval key(4, "double", 0.45, 486, "ls SECOND")
eval key(5, "double, two threads", 0.60, 486, "ls SECOND pt 4")
eval panel("particles", 502, 750)
set xrange [0.04:12]
set xtics (0.05, 0.1, 0.2, 0.5, 1, 2, 5, 10)
set arrow 1 from 1,graph 0 to 1,graph 1 nohead ls LIMIT back
plot file("particles") using col("float, one thread"):(val("row") + 0.24):col("float, one thread from"):col("float, one thread to") with xerrorbars ls FIRST, \
     file("particles") using col("float, two threads"):(val("row") + 0.08):col("float, two threads from"):col("float, two threads to") with xerrorbars ls FIRST pt 6, \
     file("particles") using col("double, one thread"):(val("row") - 0.08):col("double, one thread from"):col("double, one thread to") with xerrorbars ls SECOND, \
     file("particles") using col("double, two threads"):(val("row") - 0.24):col("double, two threads from"):col("double, two threads to") with xerrorbars ls SECOND pt 4, \
     file("particles") every ::1 using (1):col("row"):(""):ytic(variant) with labels
unset arrow 1

eval head("{/:Bold Thirty-two orbits at once:} ns for a step of one of them, ".FLAGS, 814)
eval key(2, "symplectic\\_euler", 0.05, 842, "ls SYMPLECTIC_EULER pt 4")
eval key(3, "and -fno-math-errno", 0.31, 842, "ls SYMPLECTIC_EULER")
eval key(4, "rk4", 0.62, 842, "ls RK4 pt 12")
eval key(5, "and -fno-math-errno", 0.70, 842, "ls RK4")
set label 9 MACHINE at screen 0.97,y(1006) right noenhanced font ",12"
eval panel("many", 858, 954)
set xrange [0.5:30]
set xtics (0.5, 1, 2, 5, 10, 20)
plot file("many") using col("symplectic_euler"):(val("row") + 0.14):col("symplectic_euler from"):col("symplectic_euler to") with xerrorbars ls SYMPLECTIC_EULER pt 4, \
     file("many") using col("symplectic_euler without errno"):(val("row") - 0.14):col("symplectic_euler without errno from"):col("symplectic_euler without errno to") with xerrorbars ls SYMPLECTIC_EULER, \
     file("many") using col("rk4"):(val("row") + 0.14):col("rk4 from"):col("rk4 to") with xerrorbars ls RK4 pt 12, \
     file("many") using col("rk4 without errno"):(val("row") - 0.14):col("rk4 without errno from"):col("rk4 without errno to") with xerrorbars ls RK4, \
     file("many") every ::1 using (1):col("row"):(""):ytic(variant) with labels
unset multiplot
