eval NARROW ? canvas(400, 520) : canvas(720, 500)
set xlabel "time of one step  [ns]" offset 0,0.3
set logscale x
set xrange [0.06:80]
set xtics ("0.1" 0.1, "1" 1, "10" 10)
unset mxtics
rows = exact("rows")
set yrange [rows + 0.6:0.4]
unset ytics
set grid xtics back ls GRID
set lmargin NARROW ? 14.5 : 16
set tmargin NARROW ? 6 : 3.8
array layouts = ["structs of double", "structs of double", "structs of double", "packs of float", "packs of float"]
array bodies = [1, 512, 100000, 512, 100000]
array shapes = [6, 7, 5, 7, 5]
loop = "one of ".number("at-once")
beyond = "one of ".number("beyond-the-cache")
array said = ["one body", loop, beyond, (NARROW ? "packs, " : "in packs of floats, ").loop, NARROW ? "packs, ".number("beyond-the-cache") : beyond]
array looks = [SYMPLECTIC_EULER, SYMPLECTIC_EULER, SYMPLECTIC_EULER, FIRST, FIRST]
do for [i=1:5] {
  across = NARROW ? (i % 2 ? -0.45 : 0.2) : i < 4 ? 0.28*(i - 1) : 0.56*(i - 4)
  up = NARROW ? 1.2 - 0.06*((i - 1)/2) : 1.11 - 0.055*(i > 3)
  set label i said[i] at graph across, graph up left offset 1,-0.2 point ls looks[i] pt shapes[i] ps 0.8
}
of(i) = txt("layout") eq layouts[i] && val("bodies") == bodies[i] ? val("ns") : NaN
tip(i) = sprintf("%s, %s, %d: %.2g ns", txt("method"), txt("layout"), val("bodies"), val("ns"))
plot file("layouts") every 5 using (0.06):(val("row")):(txt("method")) with labels right offset -0.4,0, \
     for [i=1:5] file("layouts") using (of(i)):(val("row")) with points ls looks[i] pt shapes[i] ps 0.8, \
     for [i=1:5] file("layouts") using (of(i)):(val("row")):(tip(i)) with labels hypertext point ls looks[i] pt shapes[i] ps 0.8, \
     for [i=1:5] file("layouts-here") using (of(i)):(val("row")) with points ls EXACT pt 2 ps 0.5
