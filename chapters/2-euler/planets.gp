eval NARROW ? canvas(400, 395) : canvas(620, 600)
eval axis_names("x  [AU]", "y  [AU]")
set size ratio -1
set xrange [-36:54]
set yrange [-36:50]
set xtics 25
set ytics 25
array name = ["Jupiter", "Saturn", "Uranus", "Neptune", "Pluto"]
set label 1 "Pluto" at 42,33 left tc ls EXACT
set label 2 "Neptune" at 0,31 center tc ls EXACT
set label 3 "Uranus" at 0,-23.5 center tc ls EXACT
set label 4 "Jupiter" at 33,-25 left tc ls EULER
set label 5 "Saturn" at -34,NARROW ? 34 : 30 left tc ls SECOND
set arrow 4 from 32.5,-24 to 12,-10 nohead lc rgb "#000001"
array look = [EULER, SECOND, CONTEXT, CONTEXT, CONTEXT]
array once = [26, 56, 156, 304, 456]  # rows that make one turn
x(body) = name[body]." x"
y(body) = name[body]." y"
plot for [body=5:1:-1] file("planets-euler") every (body <= 2 ? 1 : 3) using col(x(body)):col(y(body)) with lines ls look[body] lw (body <= 2 ? 0.8 : 0.5), \
     for [body=1:5] file("planets-true") every ::0::once[body] using col(x(body)):col(y(body)) with lines ls EXACT dt solid lw 1, \
     for [body=1:5] file("planets-euler") every 40 using col(x(body)):col(y(body)): \
       (sprintf("%s after %.0f years: %.1f AU from the sun", name[body], val("day")/365.25, \
        sqrt(val(x(body))**2 + val(y(body))**2))) with labels hypertext point ls look[body] ps 0.25
