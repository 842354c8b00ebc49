eval NARROW ? canvas(400, 400) : canvas(720, 400)
# Three strips of film side by side: a frame below the other, and in each a runner who comes from the left and turns at a wall.
array shown = ["newest state", "blended", "extrapolated"]
array looks = [FIRST, SECOND, THIRD]
frames = NARROW ? 12 : 16
# From this row of the table on, and so far behind the wall [cm].
row = NARROW ? 10 : 7
behind = 6
before = 2.4*frames - 7
wide = before + behind
apart = NARROW ? 2.5 : 5
left(i) = (i - 1)*(wide + apart)
unset border
unset xtics
set ytics 0,4 scale 0
set grid noxtics noytics
set lmargin NARROW ? 4 : 6
set rmargin 1
set tmargin 2
set bmargin 1.6
set xrange [-0.5:left(3) + wide + 0.5]
set yrange [frames - 0.3:-0.6]
do for [i=1:3] {
  set label i shown[i] at left(i) + wide/2,-1.1 center tc ls looks[i]
  set object i rectangle from left(i) + before,-0.5 to left(i) + wide,frames - 0.5 back lw 0 fc rgb "#00000d" fs solid noborder
  set object 10 + i rectangle from left(i),-0.5 to left(i) + wide,frames - 0.5 lw 0.6 fs empty border lc rgb "#000009"
  do for [n=1:frames - 1] { set arrow 100*i + n from left(i),n - 0.5 to left(i) + wide,n - 0.5 nohead ls GRID }
  set arrow 100*i from left(i) + before,-0.5 to left(i) + before,frames - 0.5 nohead ls LIMIT
}
set label 4 "frame" at left(1) - 0.8,-1.1 right tc ls EXACT
set label 5 "wall" at left(3) + before + behind/2.,frames + 0.1 center tc ls LIMIT
bar = 10
set label 6 sprintf("%g cm", bar) at left(1) + bar + 0.8,frames + 0.1 left tc ls EXACT
set arrow 400 from left(1),frames + 0.1 to left(1) + bar,frames + 0.1 heads size screen 0.008,90 ls EXACT dt solid
begun = cell("display", row, "frame")
across(i) = left(i) + before + val(shown[i])
said(i) = sprintf("%s: %.2f cm %s the wall", shown[i], abs(val(shown[i])), val(shown[i]) > 0 ? "behind" : "before")
plot for [i=1:3] file("display") every ::row::row + frames - 1 using (across(i)):(val("frame") - begun) with points ls looks[i] pt 7 ps (NARROW ? 0.8 : 1), \
     for [i=1:3] file("display") every ::row::row + frames - 1 using (across(i)):(val("frame") - begun):(said(i)) with labels hypertext point ls looks[i] ps 0.2
