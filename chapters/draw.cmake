# Draws the figure NAME with SCRIPT, in one size. Whatever gnuplot says is a mistake in it: gnuplot itself goes on after a
# warning, with points that are missing.
execute_process(
  COMMAND ${GNUPLOT} -e "NAME='${NAME}'" -e "DATA='${DATA}/'" -e "METHODS='${METHODS}'" -e "NUMBERS='${DATA}/numbers.txt'" -e "OUT='${OUT}/'"
          -e "WIDTH=${WIDTH}" -e "HEIGHT=${HEIGHT}" -e "NARROW=${NARROW}" ${STYLE} ${SCRIPT} ${AXES}
  RESULT_VARIABLE result OUTPUT_VARIABLE said ERROR_VARIABLE said)
if(NOT result EQUAL 0 OR said)
  file(REMOVE ${OUT}/${NAME}.svg ${OUT}/${NAME}.axes.json)
  message("${said}")  # verbatim; FATAL_ERROR breaks lines
  message(FATAL_ERROR "${SCRIPT} is not drawn: gnuplot says the above")
endif()
