# How many lines COMPILER reads for a header: few for one that needs no library of mathematics, and
# not many more than <cmath> for one that does. What needs Eigen is heavy by that. And whether it is
# standard C++, since not every compiler that readers have can be tried.
function(lines_of text lines)
  file(WRITE ${SCRATCH}/header.cpp "${text}\n")
  execute_process(COMMAND ${COMPILER} -std=c++20 -E -P ${SCRATCH}/header.cpp
                  OUTPUT_VARIABLE read COMMAND_ERROR_IS_FATAL ANY)
  string(REGEX MATCHALL "\n" read "${read}")
  list(LENGTH read count)
  set(${lines} ${count} PARENT_SCOPE)
endfunction()

lines_of("#include <cmath>" mathematics)
file(GLOB headers ${INTEGRATE}/*.h ${SHELF}/*.h)
foreach(header IN LISTS headers)
  file(READ ${header} text)
  string(REGEX REPLACE "\n#ifdef __clang__[^#]*#endif" "" text "${text}")  # nobody else reads it
  if(text MATCHES "__attribute__|__builtin|__declspec|#pragma GCC|\\[\\[gnu|__int128|typeof")
    message(SEND_ERROR "${header} has \"${CMAKE_MATCH_0}\", which is no standard C++")
  endif()
  file(STRINGS ${header} eigen REGEX "^#include <Eigen/")
  if(eigen)
    continue()
  endif()
  file(STRINGS ${header} cmath REGEX "^#include <cmath>")
  set(limit 6000)
  if(cmath)
    math(EXPR limit "${mathematics} + 1000")
  endif()
  lines_of("#include \"${header}\"" count)
  if(count GREATER limit)
    message(SEND_ERROR "${header} brings ${count} lines, and at most ${limit} are allowed; "
      "what does it include that the step does not need?")
  endif()
endforeach()
