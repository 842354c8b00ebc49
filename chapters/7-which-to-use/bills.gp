eval NARROW ? canvas(400, 445) : canvas(720, 445)
set xlabel NARROW ? "evaluations per second of play" : "evaluations per second of play, all six within a centimetre" offset 0,0.3
set logscale x
set xrange [250:NARROW ? 66000 : 40000]
last = rows("bills") - 1
set yrange [last + 1.6:0.4]
never = NARROW ? 44000 : 24000
set xtics ("300" 300, "1000" 1000, "3000" 3000, "10 000" 10000, "never" never)
if (NARROW) set xtics ("300" 300, "1000" 1000, "3000" 3000, "never" never)
unset mxtics
set ytics scale 0
set grid xtics ytics back ls GRID
set lmargin NARROW ? 15.5 : 16
set tmargin 1
edge = NARROW ? 30000 : 15000
set arrow 1 from edge,0.4 to edge,last + 1.6 nohead ls LIMIT
price = "evaluations a second"
paid(name) = txt(name) eq "inf" ? never : val(name)
of(m) = txt("method") eq m ? paid(price) : NaN
plot file("bills") every ::1 using (paid(price)):($0 + 1):ytic(txt("method")) with points ls EXACT ps 0, \
     file("bills") every ::1 using (of("the choice for each")):($0 + 1) with points ls EXACT pt 7 ps 0.8, \
     for [m in CONTENDERS] file("bills") every ::1 using (of(m)):($0 + 1) with points ls style(m), \
     file("bills") every ::1 using (paid(price)):($0 + 1):(txt(price) eq "inf" ? "" : txt(price)) with labels left offset 0.9,0 tc ls EXACT
