eval axis_names("particles", "time of a step of a particle  [ns]")
set logscale x
set xrange [3000:6.5e6]
set yrange [0:2.5]
set xtics ("4096" 4096, "65 536" 65536, "10^{6}" 1e6, "4×10^{6}" 4e6)
unset mxtics
set label 4 "grey: memory alone" at graph 0.99,0.6 right tc ls CONTEXT
visit = exact("steps-a-visit")
tip = "%d particles: %.2f ns"
place(name) = sprintf(tip, val("particles"), val(name))
plot file("memory-wall") using col("particles"):col("structs") with linespoints ls FIRST, \
     file("memory-wall") using col("particles"):col("memory") with linespoints ls CONTEXT lw 3, \
     file("memory-wall") using col("particles"):col("packs") with linespoints ls SECOND, \
     file("memory-wall") using col("particles"):col("blocks") with linespoints ls THIRD, \
     file("memory-wall") using col("particles"):col("structs"):(place("structs")) with labels hypertext point ls FIRST, \
     file("memory-wall") using col("particles"):col("packs"):(place("packs")) with labels hypertext point ls SECOND, \
     file("memory-wall") using col("particles"):col("blocks"):(place("blocks")) with labels hypertext point ls THIRD, \
     file("memory-wall") every ::2::2 using col("particles"):col("structs"):("one struct for each") with labels left offset 0,-0.8 tc ls FIRST, \
     file("memory-wall") every ::4::4 using col("particles"):col("packs"):("packs, one step a visit") with labels right offset 0,1.3 tc ls SECOND, \
     file("memory-wall") every ::6::6 using col("particles"):col("blocks"):(sprintf("packs, %d steps a visit", visit)) with labels right offset 0,-0.9 tc ls THIRD
