# Compiles SOURCE as a reader would and runs it; or, with WRONG, checks that it does not compile and
# that the message says what was wanted in at most 20 lines. Without EIGEN, Eigen is not to be found.
set(program ${SOURCE}-${TAG})
set(eigen)
if(EIGEN)
  set(eigen -isystem ${EIGEN})
endif()
execute_process(
  COMMAND ${COMPILER} -std=c++${STANDARD} -I${STEPS} ${eigen} -Wall -Wextra -Wpedantic -Wconversion
          -Wshadow -Werror -fno-exceptions -fno-rtti ${SOURCE} -o ${program}
  RESULT_VARIABLE result ERROR_VARIABLE errors)

if(WRONG)
  string(REGEX MATCHALL "\n" lines "${errors}")
  list(LENGTH lines count)
  if(NOT result OR count GREATER 20
     OR NOT errors MATCHES "acceleration must be callable as Vec\\(x, v, t\\)")
    message(FATAL_ERROR "result ${result}, ${count} lines; wanted a short error:\n${errors}")
  endif()
  return()
endif()

if(result)
  message(FATAL_ERROR "${SOURCE} does not compile:\n${errors}")
endif()
execute_process(COMMAND ${program} RESULT_VARIABLE result OUTPUT_VARIABLE output)
if(result)
  message(FATAL_ERROR "${SOURCE}: not the same steps (${result})\n${output}")
endif()
