eval NARROW ? canvas(400, 1130) : canvas(720, 300)
unset border
unset tics
unset grid
set size ratio -1
set lmargin 0
set rmargin 0
set tmargin 0
set bmargin 0
# Three stretches of the same run, in fields as wide: side by side, and one below the other on a phone.
side = 90
half = 43
across(panel) = NARROW ? 0 : panel*side
up(panel) = NARROW ? -panel*(side + 6) : 0
set xrange [-half - 1:across(2) + half + 1]
set yrange [up(2) - half - 1:half + 8]
# Rows of 200 days: until the meeting, around it, and what is left.
row(year) = int(year*365.25/200)
met = exact("meeting-year")
array begins = [0, row(met - 4.5), row(met + 4.5)]
array ends = [row(met - 4.5), row(met + 4.5), row(exact("years"))]
array words = ["until the meeting", "nine years around it", "the rest"]
larger(p) = p == 1 ? 3 : 1
do for [p=0:2] {
  set object p + 1 rectangle center across(p),up(p) size 2*half,2*half lw 0.6 fs empty border lc rgb "#000009"
  set label p + 1 words[p + 1] at across(p) - half,up(p) + half + 3.5 left tc ls EXACT
}
array name = ["Jupiter", "Saturn", "Uranus", "Neptune", "Pluto"]
array once = [26, 56, 156, 304, 456]  # rows that make one turn
set label 11 "Jupiter" at across(1) + 10,up(1) + 26 left tc ls EULER
set label 12 "Saturn" at across(1) + 6,up(1) + 33 left tc ls EULER
x(body) = name[body]." x"
y(body) = name[body]." y"
shown(p, name) = larger(p)*val(name)
px(p, body) = abs(shown(p, x(body))) < half && abs(shown(p, y(body))) < half ? across(p) + shown(p, x(body)) : NaN
py(p, body) = up(p) + shown(p, y(body))
# All five true orbits in the first field and the last, and the two that fit in the middle one.
field(i) = i < 5 ? 0 : i < 10 ? 2 : 1
body(i) = 1 + i % 5
plot for [i=0:11] file("planets-true") every ::0::once[body(i)] using (px(field(i), body(i))):(py(field(i), body(i))) with lines ls CONTEXT lw 0.9, \
     for [p=0:2] file("planets-euler") every ::(begins[p+1])::(ends[p+1]) using (px(p, 2)):(py(p, 2)) with lines ls EULER dt (2,3) lw (p == 1 ? 1.8 : 0.9), \
     for [p=0:2] file("planets-euler") every ::(begins[p+1])::(ends[p+1]) using (px(p, 1)):(py(p, 1)) with lines ls EULER lw (p == 1 ? 1.8 : 0.7), \
     for [p=0:2] "+" every 1000 using (across(p)):(up(p)) with points ls CONTEXT pt 7 ps 0.6
