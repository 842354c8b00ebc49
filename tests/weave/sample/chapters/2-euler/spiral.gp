# The planet's way outwards.
set output OUT . NAME . ".svg"
plot file("growth") using col("h"):col("factor") with lines title "Euler"
