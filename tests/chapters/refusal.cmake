# refuses(reason arguments...): PROGRAM must refuse them with exit code 2, nothing on stdout, and on
# stderr one line that begins with NAME and gives the reason.
function(refuses reason)
  execute_process(COMMAND ${PROGRAM} ${ARGN} RESULT_VARIABLE code OUTPUT_VARIABLE out ERROR_VARIABLE err)
  if(NOT code EQUAL 2)
    message(SEND_ERROR "${ARGN}: exit code ${code}, expected 2")
  endif()
  if(NOT out STREQUAL "")
    message(SEND_ERROR "${ARGN}: printed on stdout: ${out}")
  endif()
  if(NOT err MATCHES "^${NAME}: [^\n]*${reason}[^\n]*\n$")
    message(SEND_ERROR "${ARGN}: expected one line with '${reason}', got: ${err}")
  endif()
endfunction()
