# The look of every figure in the book. gnuplot runs this file, then the figure's own script, then
# axes.gp. Before it, the build sets NAME, DATA, METHODS, OUT, WIDTH, HEIGHT and NARROW (1 for a phone).
#
# Colours are stand-ins: the weaver turns #000001 to #000011 into the style sheet's --plot-1 to
# --plot-17, so that a figure follows the page from light to dark. Black becomes the text's colour.

set datafile separator ","
set datafile missing NaN
set encoding utf8
set minussign
# A figure that wants another shape than the page's calls `eval canvas(width, height)` first.
canvas(w, h) = sprintf("WIDTH = %d; HEIGHT = %d; set terminal svg size %d,%d dynamic enhanced rounded font 'Book Sans,15'; set output '%s%s.svg'", w, h, w, h, OUT, NAME)
eval canvas(WIDTH, HEIGHT)

# A name's place in a list of names, "\t1:t\t2:x\t"; 0 where it isn't there.
place_in(list, name, n) = strstrt(list, sprintf("\t%d:%s\t", n, name)) ? n : strstrt(list, sprintf("\t%d:", n)) ? place_in(list, name, n + 1) : 0
# Says what is wrong, and calls what there is not: no other mistake is sure to stop gnuplot inside `using`.
refuse(message) = (system("echo '".NAME.": ".message."' >&2"), no_such_name(0))

# The styles of lines. A method's goes by the name that it has in code/measure/methods: `ls style("Heun")`, or `ls HEUN`;
# one method has one colour in all figures. Its kin have the family's colour, another dash and symbol. The build writes METHODS
# of the looks that stand there, and CONTENDERS, the names of those that run against each other.
STYLES = "\t"
LINES = 0
line_style(id, look) = sprintf("LINES = LINES + 1; %s = LINES; set style line LINES %s", id, look)
method(name, id, look) = sprintf("%s; STYLES = STYLES.LINES.\":%s\\t\"", line_style(id, look), name)
style(name) = place_in(STYLES, name, 1) ? place_in(STYLES, name, 1) : refuse("figure.gp has no style for \"".name."\"")

load METHODS
# What is no method.
eval line_style("EXACT", "lc rgb '#000007' lw 1.4 dt (7,5) pt 6 ps 0.6")  # what the motion really is
eval line_style("LIMIT", "lc rgb '#000008' lw 1.6 dt (3,4) pt 7 ps 0.6")  # where something ends
eval line_style("CONTEXT", "lc rgb '#000009' lw 1.1 pt 7 ps 0.4")         # what only helps the eye
# Things, scenes and settings, which have the colour of no method.
eval line_style("FIRST", "lc rgb '#00000f' lw 2.2 pt 7 ps 0.6")
eval line_style("SECOND", "lc rgb '#000010' lw 2.2 pt 5 ps 0.55")
eval line_style("THIRD", "lc rgb '#000011' lw 2.2 pt 9 ps 0.7")
eval line_style("AREA", "lc rgb '#00000d' lw 1")                          # a faint fill
eval line_style("GRID", "lc rgb '#00000e' lw 1")

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
# A figure of several panels says where each lies on its own axes, for the same test: `PANELS = PANELS.panel(...)`.
PANELS = ""
panel(left, right, bottom, top, x_min, x_max, y_min, y_max) = sprintf('%s{"left": %.17g, "right": %.17g, "bottom": %.17g, "top": %.17g, "x": [%.17g, %.17g], "y": [%.17g, %.17g]}', strlen(PANELS) ? ", " : "", left, right, bottom, top, x_min, x_max, y_min, y_max)
# A script reaches its tables by name. file("orbit") is the table orbit.csv; behind it, while gnuplot reads that table,
# col("t") is the column of that name, as a place of `using` wants it, val("t") is what a row has there, and
# txt("method") the same as text, up to a comma: gnuplot goes no further. A name that the table doesn't have stops
# gnuplot. (Its own column("t") goes on where that only costs points: in a hover text, for a colour, in one branch of ?:.)
TABLE = ""
# The names in the first line, in place_in's form; one in quotes may hold commas.
header(path) = system("awk -F '\"' -v OFS= 'NR == 1 { for (i = 1; i <= NF; i += 2) gsub(/,/, \"\\t\", $i); n = split($0, names, \"\\t\"); printf \"\\t\"; for (i = 1; i <= n; ++i) printf \"%d:%s\\t\", i, names[i]; exit }' '".path."'")
file(name) = (name eq TABLE ? 0 : (TABLE = name, HEADER = header(DATA.name.".csv")), DATA.name.".csv")
col(name) = place_in(HEADER, name, 1) ? place_in(HEADER, name, 1) : refuse(TABLE.".csv has no column \"".name."\"")
val(name) = column(col(name))
txt(name) = strcol(col(name))
# A number of a table by its row, counted from 1 below the header, for an arrow or the like.
cell(table, row, name) = (file(table), number_in(system(sprintf("awk -F, 'NR == %d { print $%d }' '%s%s.csv'", row + 1, col(name), DATA, table)), row))
rows(table) = int(system(sprintf("awk 'END { print NR - 1 }' '%s%s.csv'", DATA, table)))
number_in(text, row) = strlen(text) ? real(text) : refuse(sprintf("%s.csv has no row %d", TABLE, row))

# What stands in a column of text, each once; and in the rows that have a word in another: for a loop such as
# `plot for [m in names("work", "method", "thing", "leaf")] ...`
each(table, name) = (file(table), system(sprintf("awk -F, 'NR > 1 && !seen[$%d]++ { printf \"\\047%%s\\047 \", $%d }' '%s%s.csv'", col(name), col(name), DATA, table)))
names(table, name, key, word) = (file(table), names_if(table, name, sprintf("$%d == \"%s\"", col(key), word)))
# The same, if the row has a number in a third column: of a new method no times are recorded.
names_with(table, name, key, word, number) = (file(table), names_if(table, name, sprintf("$%d == \"%s\" && $%d != \"nan\"", col(key), word, col(number))))
names_if(table, name, condition) = system(sprintf("awk -F, 'NR > 1 && %s && !seen[$%d]++ { printf \"\\047%%s\\047 \", $%d }' '%s%s.csv'", condition, col(name), col(name), DATA, table))

# What the chapter's program recorded: number("apex") is the text that \number{apex} is on the page, "1.27 m", and
# exact("apex") is the value. The build writes NUMBERS: name, value, text.
entry(name, field) = system(sprintf("awk -F '\t' '$1 == \"%s\" { print $%d }' '%s'", name, field, NUMBERS))
recorded(text, name) = strlen(text) ? text : refuse("the program records no number \"".name."\"")
number(name) = recorded(entry(name, 3), name)
# A formula asks for the same one at each of its points: the last one is kept.
LAST = ""
exact(name) = (name eq LAST ? 0 : (VALUE = real(recorded(entry(name, 2), name)), LAST = name), VALUE)
