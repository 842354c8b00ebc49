# Writes where the axes of the last plot lie in its picture, for the test that reads the ticks.
unset output
set print OUT.NAME.".axes.json"
side(low, high, from, to) = sprintf( \
  '{"min": %.17g, "max": %.17g, "pixel_min": %.17g, "pixel_max": %.17g}', low, high, from, to)
print '{"x": ', side(GPVAL_X_MIN, GPVAL_X_MAX, GPVAL_TERM_XMIN, GPVAL_TERM_XMAX), ','
print '"y": ', side(GPVAL_Y_MIN, GPVAL_Y_MAX, HEIGHT - GPVAL_TERM_YMIN, HEIGHT - GPVAL_TERM_YMAX), ','
print '"panels": [', PANELS, ']}'
set print
