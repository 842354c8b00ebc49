# Fails unless all claims of the report that the build keeps are true, those that the prose doesn't name, too. Of what is false,
# CLAIMS itself then says where and why.
file(READ ${REPORT} report)
if(NOT report MATCHES "<OverallResultsCases successes=\"([1-9][0-9]*)\" failures=\"0\" expectedFailures=\"0\" skips=\"0\"/>")
  execute_process(COMMAND ${CLAIMS})
  message(FATAL_ERROR "${REPORT} has claims that are false, or none")
endif()
message("${CMAKE_MATCH_1} claims hold")
