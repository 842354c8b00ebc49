eval canvas(300, 280)
unset border
unset tics
set lmargin 0
set rmargin 0
set tmargin 0
set bmargin 0
set size ratio -1
set xrange [-38:58]
set yrange [-38:54]
array name = ["Jupiter", "Saturn", "Uranus", "Neptune", "Pluto"]
array look = [FIRST, SECOND, CONTEXT, CONTEXT, THIRD]
x(body) = name[body]." x"
y(body) = name[body]." y"
set label 1 "Pluto" at 40,41 left tc ls THIRD
set label 2 "Neptune" at 0,33.5 center
set label 3 "Jupiter" at 24,-30 left tc ls FIRST
set arrow 3 from 23,-28 to 3.6,-4.6 nohead ls CONTEXT
set label 9 "" at 0,0 point ls EXACT pt 7 ps 0.9
plot for [body=1:5] file("planets") using col(x(body)):col(y(body)) with lines ls look[body] lw 1.2, \
     for [body=1:5] file("planets") every ::1::1 using col(x(body)):col(y(body)) with points ls look[body] pt 7 ps 0.6
