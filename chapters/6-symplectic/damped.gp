eval axis_names("damping ratio  {/:Italic ζ}", "largest stable step, {/:Italic hω}")
set xrange [0:2]
set yrange [0:5]
set xtics 0.5
set ytics 1
set label 1 "Euler" at 0.97,2.2 right tc ls EULER
set label 2 "drag in the acceleration" at 1.97,0.2 right tc ls SYMPLECTIC_EULER
set label 3 "{/:Italic v} / (1 + {/:Italic ch}) + {/:Italic ha}" at 1.97,1.85 right tc ls SECOND
set label 4 "({/:Italic v} + {/:Italic ha}) / (1 + {/:Italic ch})" at 1.08,4.3 left tc ls FIRST
set label 5 "1/√3" at 0.6,0.22 left tc ls LIMIT
set arrow 1 from 1/sqrt(3),0 to 1/sqrt(3),2/sqrt(3) nohead ls LIMIT
tip = "ζ = %.2f: stable under hω = %.3f"
plot 2*(sqrt(1 + x*x) - x) with lines ls CONTEXT, 2*(sqrt(1 + x*x) + x) with lines ls CONTEXT, \
     file("damped") using col("ζ"):col("Euler") with linespoints ls EULER lw 1.4 ps 0.45, \
     file("damped") using col("ζ"):col("first") with linespoints ls SECOND lw 1.4 ps 0.5, \
     file("damped") using col("ζ"):(val("last") < 5 ? val("last") : NaN) with points ls FIRST ps 0.5, \
     file("damped") using col("ζ"):col("symplectic Euler") with points ls SYMPLECTIC_EULER ps 0.5, \
     file("damped") every 4 using col("ζ"):col("Euler"):(sprintf(tip, val("ζ"), val("Euler"))) with labels hypertext point ls EULER ps 0.45, \
     file("damped") every 4 using col("ζ"):col("symplectic Euler"):(sprintf(tip, val("ζ"), val("symplectic Euler"))) with labels hypertext point ls SYMPLECTIC_EULER ps 0.5, \
     file("damped") every 4 using col("ζ"):col("first"):(sprintf(tip, val("ζ"), val("first"))) with labels hypertext point ls SECOND ps 0.5
