# SPDX-License-Identifier: MIT-0
# Keeps what `prove` says of one exercise; says it and fails if the tests are not as good as they should be.
execute_process(COMMAND ${PROVE} ${EXERCISE} OUTPUT_VARIABLE said ERROR_VARIABLE said RESULT_VARIABLE result)
if(NOT result EQUAL 0)
  message(FATAL_ERROR "${said}")
endif()
file(WRITE ${PROOF} "${said}")
