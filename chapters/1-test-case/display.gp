eval NARROW ? canvas(400, 400) : canvas(720, 400)
# Two strips of film side by side: a frame below the other, and in each a runner from left to right.
frames = NARROW ? 11 : 15
wide = 2.4*frames + 1.2
apart = NARROW ? 3 : 5
left(i) = (i - 1)*(wide + apart)
array shown = ["newest state", "blended"]
array looks = [FIRST, SECOND]
unset border
unset xtics
set ytics 0,4 scale 0
set grid noxtics noytics
set lmargin NARROW ? 5 : 6
set tmargin 2
set bmargin 1.6
set xrange [-0.5:left(2) + wide + 0.5]
set yrange [frames - 0.3:-0.6]
do for [i=1:2] {
  set label i shown[i] at left(i) + wide/2,-1.1 center tc ls looks[i]
  set object i rectangle from left(i),-0.5 to left(i) + wide,frames - 0.5 lw 0.6 fs empty border lc rgb "#000009"
  do for [n=1:frames - 1] { set arrow 100*i + n from left(i),n - 0.5 to left(i) + wide,n - 0.5 nohead ls GRID }
}
set label 3 "frame" at left(1) - 0.8,-1.1 right tc ls EXACT
bar = 10
set label 4 sprintf("%g cm", bar) at left(2) + wide - bar - 0.8,frames + 0.1 right tc ls EXACT
set arrow 300 from left(2) + wide - bar,frames + 0.1 to left(2) + wide,frames + 0.1 heads size screen 0.008,90 ls EXACT dt solid
# From this row of the table on.
row = 10
begun = cell("display", row, "frame")
from = cell("display", row, "blended")
across(i) = left(i) + 1.2 + val(shown[i]) - from
said(i) = sprintf("%s: %.2f cm", shown[i], val(shown[i]))
plot for [i=1:2] file("display") every ::row::row + frames - 1 using (across(i)):(val("frame") - begun) with points ls looks[i] pt 7 ps (NARROW ? 1 : 1.25), \
     for [i=1:2] file("display") every ::row::row + frames - 1 using (across(i)):(val("frame") - begun):(said(i)) with labels hypertext point ls looks[i] ps 0.2
