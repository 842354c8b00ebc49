eval NARROW ? canvas(400, 760) : canvas(720, 390)
unset border
unset tics
unset grid
set size ratio -1
set lmargin 0
set rmargin 0
set tmargin 0
set bmargin 0
# Two fields of forty centimetres: side by side, and one below the other on a phone.
side = 42
half = 20
array tables = ["blob-5", "blob-15"]
left(i) = NARROW ? 0 : (i - 1)*side
top(i) = NARROW ? -(i - 1)*side : 0
set xrange [-half - 0.5:left(2) + half + 0.5]
set yrange [top(2) - half - 0.5:half + 1]
array name = ["5", "15"]
array word = ["shrinks", "grows"]
do for [i=1:2] {
  set object i rectangle center left(i),top(i) size 2*half,2*half lw 0.6 fs empty border lc rgb "#000009"
  set label i number("blob-step-".name[i]).": the blob ".word[i] at left(i) - half + 1,top(i) + half - 1.6 left tc ls EULER
  set label 10 + i "stretch" at left(i) - half + 0.6,top(i) - 1.3 left tc ls EXACT
  set label 20 + i "velocity over ω" at left(i) + 0.6,top(i) - half + 1.3 left tc ls EXACT
  set arrow 2*i from left(i) - half,top(i) to left(i) + half,top(i) nohead ls CONTEXT
  set arrow 2*i + 1 from left(i),top(i) - half to left(i),top(i) + half - 3 nohead ls CONTEXT
}
set label 31 "starts" at left(1) + 10,top(1) + 5 center tc ls EXACT
set label 32 "starts" at left(2) + 10,top(2) + 5.2 center tc ls EXACT
at(i, moment) = val("moment") == moment ? left(i) + val("stretch") : NaN
plot for [i=1:2] for [m=1:8] file(tables[i]) using (at(i, m)):(top(i) + val("velocity")) with filledcurves closed ls AREA, \
     for [i=1:2] for [m=1:8] file(tables[i]) using (at(i, m)):(top(i) + val("velocity")) with lines ls EULER lw (m == 8 ? 2.4 : 1.1), \
     for [i=1:2] file(tables[i]) using (at(i, 0)):(top(i) + val("velocity")) with lines ls EXACT
