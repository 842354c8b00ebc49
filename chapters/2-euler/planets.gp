eval NARROW ? canvas(400, 395) : canvas(620, 600)
eval axis_names("x  [AU]", "y  [AU]")
set size ratio -1
set xrange [-36:54]
set yrange [-36:50]
set xtics 25
set ytics 25
name(body) = word("Jupiter Saturn Uranus Neptune Pluto", body + 1)
set label 1 "Pluto" at 42,33 left tc rgb "#000007"
set label 2 "Neptune" at 0,31 center tc rgb "#000007"
set label 3 "Uranus" at 0,-23.5 center tc rgb "#000007"
set label 4 "Jupiter" at 33,-25 left tc rgb "#000001"
set label 5 "Saturn" at -34,NARROW ? 34 : 30 left tc rgb "#00000b"
set arrow 4 from 32.5,-24 to 12,-10 nohead lc rgb "#000001"
look(body) = body == 0 ? EULER : body == 1 ? SECOND : CONTEXT
once(body) = word("26 56 156 304 456", body + 1) + 0  # rows that make one turn
plot for [body=4:0:-1] file("planets-euler") every (body < 2 ? 1 : 3) using (column(2*body + 2)):(column(2*body + 3)) with lines ls look(body) lw (body < 2 ? 0.8 : 0.5), \
     for [body=0:4] file("planets-true") every ::0::once(body) using (column(2*body + 2)):(column(2*body + 3)) with lines ls EXACT dt solid lw 1, \
     for [body=0:4] file("planets-euler") every 40 using (column(2*body + 2)):(column(2*body + 3)): \
       (sprintf("%s after %.0f years: %.1f AU from the sun", name(body), $1/365.25, \
        sqrt(column(2*body + 2)**2 + column(2*body + 3)**2))) with labels hypertext point ls look(body) ps 0.25
