# The look of every figure in the book. gnuplot runs this file, then the figure's own script, then
# axes.gp. Before it, the build sets NAME, DATA, OUT, WIDTH, HEIGHT and NARROW (1 for a phone).
#
# Colours are stand-ins: the weaver turns #000001 to #00000e into the style sheet's --plot-1 to
# --plot-14, so that a figure follows the page from light to dark. Black becomes the text's colour.

set datafile separator ","
set datafile missing NaN
set encoding utf8
set minussign
# A figure that wants another shape than the page's calls `eval canvas(width, height)` first.
canvas(w, h) = sprintf("WIDTH = %d; HEIGHT = %d; set terminal svg size %d,%d dynamic enhanced rounded font 'Book Sans,15'; set output '%s%s.svg'", w, h, w, h, OUT, NAME)
eval canvas(WIDTH, HEIGHT)

# One number for each method, the same in all figures: use as a line style, `ls EULER`.
EULER = 1
SYMPLECTIC_EULER = 2
VELOCITY_VERLET = 3
RK4 = 4
BACKWARD_EULER = 5
MIDPOINT = 6
EXACT = 7       # what the motion really is
LIMIT = 8       # where something ends
CONTEXT = 9     # what only helps the eye
FIRST = 10      # three colours for what is not a method
SECOND = 11
THIRD = 12
AREA = 13       # a faint fill
GRID = 14
# Kin of the methods above: the colour of the family, another dash and symbol. Yoshida's method, the trapezoid rule and
# the step of constant acceleration have colours of their own.
HEUN = 15
STORMER_VERLET = 16
LEAPFROG = 17
YOSHIDA4 = 18
TRAPEZOID = 19
DOPRI5 = 20
PREDICTED_EULER = 21
CONSTANT_ACCELERATION = 22
LINEAR_DAMPING_IMPLICIT_LAST = 23
SPRING_EXACT = 24

set style line EULER            lc rgb "#000001" lw 2.2 pt 7 ps 0.6
set style line SYMPLECTIC_EULER lc rgb "#000002" lw 2.2 pt 5 ps 0.55
set style line VELOCITY_VERLET  lc rgb "#000003" lw 2.2 pt 9 ps 0.7
set style line RK4              lc rgb "#000004" lw 2.2 pt 13 ps 0.75
set style line BACKWARD_EULER   lc rgb "#000005" lw 2.2 pt 15 ps 0.6
set style line MIDPOINT         lc rgb "#000006" lw 2.2 pt 11 ps 0.7
set style line EXACT            lc rgb "#000007" lw 1.4 dt (7,5) pt 6 ps 0.6
set style line LIMIT            lc rgb "#000008" lw 1.6 dt (3,4) pt 7 ps 0.6
set style line CONTEXT          lc rgb "#000009" lw 1.1 pt 7 ps 0.4
set style line FIRST            lc rgb "#00000a" lw 2.2 pt 7 ps 0.6
set style line SECOND           lc rgb "#00000b" lw 2.2 pt 5 ps 0.55
set style line THIRD            lc rgb "#00000c" lw 2.2 pt 9 ps 0.7
set style line AREA             lc rgb "#00000d" lw 1
set style line GRID             lc rgb "#00000e" lw 1
set style line HEUN             lc rgb "#000006" lw 2.2 dt (6,4) pt 10 ps 0.8
set style line STORMER_VERLET   lc rgb "#000003" lw 2.2 dt (6,4) pt 8 ps 0.8
set style line LEAPFROG         lc rgb "#000003" lw 2.2 dt (2,3) pt 1 ps 0.8
set style line YOSHIDA4         lc rgb "#00000a" lw 2.2 pt 2 ps 0.8
set style line TRAPEZOID        lc rgb "#00000b" lw 2.2 dt (6,4) pt 14 ps 0.7
set style line DOPRI5           lc rgb "#000004" lw 2.2 dt (6,4) pt 12 ps 0.8
set style line PREDICTED_EULER  lc rgb "#000005" lw 2.2 dt (2,3) pt 3 ps 0.8
set style line CONSTANT_ACCELERATION lc rgb "#00000b" lw 2.2 pt 5 ps 0.55
set style line LINEAR_DAMPING_IMPLICIT_LAST lc rgb "#000002" lw 2.2 dt (6,4) pt 4 ps 0.55
set style line SPRING_EXACT     lc rgb "#000007" lw 1.4 pt 6 ps 0.6

set border 3 lw 1
set tics out nomirror scale 0.6,0.3
set grid back ls GRID
unset key
set samples 200
set lmargin NARROW ? 6 : 7
set rmargin 2
set tmargin 2.4
set bmargin 3.4

# The name of the vertical axis, written level above it; the horizontal one below.
axis_names(x, y) = sprintf("set xlabel '%s' offset 0,0.3; set label 99 '%s' at graph 0,1.0 left offset -4,0.9", x, y)
file(name) = DATA.name.".csv"
