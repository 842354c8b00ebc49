eval axis_names("steps per second", "largest error  [m]")
set logscale xy
set xrange [13:NARROW ? 1100 : 1100]
set yrange [1e-6:1000]
set xtics (15, 60, 240, 960)
set ytics ("1 µm" 1e-6, "0.1 mm" 1e-4, "1 cm" 0.01, "1 m" 1)
unset mxtics
unset mytics
set lmargin NARROW ? 8.5 : 9
set label 1 "{/:Italic x_{prev} = x}, drone" at 120,80 center tc ls THIRD
set label 2 "{/:Italic x_{prev} = x}, a swing from rest" at NARROW ? 55 : 62,0.4 left tc ls FIRST
set label 3 "{/:Italic x – hv}, drone" at 170,0.006 right tc ls SYMPLECTIC_EULER
set label 4 NARROW ? "{/:Italic x – hv + h^2a/2}" : "{/:Italic x – hv + h^2a/2}, drone" at NARROW ? 70 : 60,NARROW ? 4e-5 : 6e-5 right tc ls VELOCITY_VERLET
tip(name) = sprintf("%d steps a second: %.2g m", val("steps per second"), val(name))
plot file("starts") using col("steps per second"):col("drone x") with linespoints ls THIRD dt solid lw 2.2 ps 0.7, \
     file("starts") using col("steps per second"):col("swing x") with linespoints ls FIRST, \
     file("starts") using col("steps per second"):col("drone x − hv") with linespoints ls SYMPLECTIC_EULER, \
     file("starts") using col("steps per second"):col("drone x − hv + h²a/2") with linespoints ls STORMER_VERLET, \
     for [name in "'drone x' 'swing x' 'drone x − hv' 'drone x − hv + h²a/2'"] file("starts") using col("steps per second"):col(name):(tip(name)) with labels hypertext point ls CONTEXT ps 0.3
