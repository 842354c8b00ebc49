eval axis_names("too long by  [cm]", "link, from below")
set xrange [0:12]
set yrange [0.3:20.8]
set xtics 2
set ytics (1, 5, 10, 15, 20)
set label 1 "when it is pulled" at 7.2,10 left tc ls FIRST
set label 2 "after the step" at 4,2.5 left tc ls SECOND
set arrow 2 from 3.9,2.7 to 1.2,5 nohead ls CONTEXT
table = file("hanging-links")
plot table using (val("pulled")/2):col("link"):(0):col("pulled"):(val("link") - 0.38):(val("link") + 0.38) with boxxyerror ls FIRST fs transparent solid 0.2 border, \
     table using (val("after")/2):col("link"):(0):col("after"):(val("link") - 0.38):(val("link") + 0.38) with boxxyerror ls SECOND fs transparent solid 0.55 noborder, \
     table using col("after"):col("link"):(sprintf("link %.0f from below: %.2f cm too long when it is pulled, %.2f cm after the step", val("link"), val("pulled"), val("after"))) with labels hypertext point ls SECOND ps 0.3
