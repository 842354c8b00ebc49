# The planet's way outwards.
set output OUT . NAME . ".svg"
plot file("growth") using 1:2 with lines title "Euler"
