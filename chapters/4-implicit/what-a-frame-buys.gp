eval NARROW ? canvas(400, 660) : canvas(720, 680)
set xlabel NARROW ? "multiplications per unknown and frame" : "multiplications for each unknown and frame" offset 0,0.3
# Two panels, each one unit high, one above the other: in each the error runs from `finest` to `coarsest`.
array nets = ["rope", "cloth"]
finest = 6e-4
coarsest = 1
cheapest = NARROW ? 8 : 30
dearest = 9000
low(j) = (2 - j)*1.1
py(j, off) = low(j) + (log(off) - log(finest))/(log(coarsest) - log(finest))
set logscale x
set xrange [cheapest:dearest]
set xtics (100, 200, 500, 1000, 2000, 5000)
if (NARROW) set xtics (100, 500, 2000)
unset mxtics
set yrange [-0.03:2.06]
unset ytics
set border 1
set grid noxtics noytics
set lmargin 2
set tmargin NARROW ? 6.6 : 4.6
array errors = [1, 0.1, 0.01, 0.001]
n = 100
do for [j=1:2] {
  n = n + 1
  set label n nets[j] at graph 0.995,first low(j)+0.93 right font "Book Sans Bold"
  do for [i=1:4] {
    n = n + 1
    set arrow n from cheapest,py(j, errors[i]) to dearest,py(j, errors[i]) nohead ls GRID
    set label n sprintf(i == 1 && (!NARROW || j == 2) ? "off by %g %%" : "%g %%", 100*errors[i]) at graph 0.004,first py(j, errors[i]) left offset 0,0.4 font ",12" tc ls EXACT
  }
}
# What the symbols are, above the first panel.
array shown = ["symplectic Euler", "backward Euler", "BDF2", "trapezoid", "solved twice", "solved to the end", "conjugate gradients"]
array looks = [SYMPLECTIC_EULER, BACKWARD_EULER, BDF2, TRAPEZOID, EXACT, EXACT, EXACT]
array shapes = [5, 15, 12, 14, 4, 1, 2]
do for [i=1:7] {
  set label i shown[i] at graph (NARROW ? 0.5*((i - 1)%2) : 0.25*((i - 1)%4)),graph (NARROW ? 1.185 - 0.035*((i - 1)/2) : 1.115 - 0.037*((i - 1)/4)) left point ls looks[i] pt shapes[i] ps 0.8 offset 1.6,-0.2
}
once = "'symplectic Euler' 'backward Euler' BDF2 trapezoid"
array more = ["backward Euler twice", "BDF2 twice", "backward Euler to the end", "trapezoid to the end", "gradients to a hundredth", "gradients to a thousandth"]
array look = [BACKWARD_EULER, BDF2, BACKWARD_EULER, TRAPEZOID, BACKWARD_EULER, BACKWARD_EULER]
array shape = [4, 4, 1, 1, 2, 2]
like(m) = m eq "BDF2 twice" ? BDF2 : style(m)
at(j, m) = txt("net") eq nets[j] && txt("method") eq m ? val("work") : NaN
height(j) = val("off") > finest ? py(j, val("off")) : NaN
length(m) = (txt("until") eq "inf" || val("until") > dearest ? dearest : val("until")) - val("work")
tip(j) = sprintf("%s, %d a frame: off by %.2g, %.3g multiplications", txt("method"), val("steps"), val("off"), val("work"))
best = "'symplectic Euler' 'backward Euler' BDF2 'BDF2 twice'"
# The panel of a row; not every method is an answer in each.
panel(m) = txt("net") eq nets[1] ? 1 : 2
answer(m) = txt("method") eq m ? val("work") : NaN
level(m) = height(panel(m))
# A method's name stands at its first answer in a panel, and the steps in a frame above, if more than one.
fewest(m) = txt("net") eq nets[2] ? exact("cloth-substeps") : exact("rope-fewest")
first(m) = m eq "symplectic Euler" ? fewest(m) : 1
begun(m) = val("steps") == first(m) ? answer(m) : NaN
counted(m) = val("steps") == 1 || (m eq "symplectic Euler" && val("steps") > fewest(m)) ? NaN : answer(m)
plot for [m in best] file("seen-answers") using (answer(m)):(level(m)):(length(m)):(0) with vectors nohead ls like(m) lw 7 dt solid, \
     for [j=1:2] for [m in once] file("seen") using (at(j, m)):(height(j)) with linespoints ls style(m) lw 1.2 dt solid, \
     for [j=1:2] for [i=1:6] file("seen") using (at(j, more[i])):(height(j)) with points ls look[i] pt shape[i] ps 0.9, \
     for [j=1:2] file("seen") using (txt("net") eq nets[j] ? val("work") : NaN):(height(j)):(tip(j)) with labels hypertext point ls CONTEXT ps 0.2, \
     for [m in "BDF2 'symplectic Euler' 'backward Euler'"] file("seen-answers") using (begun(m)):(level(m)):(m) with labels right offset -1,(m eq "backward Euler" ? 0.2 : -0.3) tc ls like(m), \
     for [m in "'symplectic Euler' BDF2"] file("seen-answers") using (counted(m)):(level(m)):(sprintf("%d", val("steps"))) with labels left offset 0.2,0.75 tc ls style(m)
