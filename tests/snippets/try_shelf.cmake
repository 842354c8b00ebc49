# Compiles a program that calls all functions of HEADERS, which stand alone in its folder, on the kinds of vectors
# of KINDS, which are headers in tests/snippets/kinds, and runs it. With MACROS, a file of macros, the
# headers are read after them, and after all that they include. FLAGS are the compiler's.
string(REPLACE "," ";" HEADERS "${HEADERS}")
string(REPLACE "," ";" KINDS "${KINDS}")
string(REPLACE "," ";" FLAGS "${FLAGS}")
file(REMOVE_RECURSE ${SCRATCH})
set(includes "")
set(needed "")
set(calls "")
set(adapters "")
set(kinds "")
foreach(header IN LISTS HEADERS)
  file(COPY ${SHELF}/${header}.h DESTINATION ${SCRATCH})
  string(APPEND includes "#include \"${header}.h\"\n")
  file(STRINGS ${SHELF}/${header}.h lines REGEX "^#include <")
  list(APPEND needed ${lines})
  string(APPEND adapters "#include \"shelf_calls/${header}.h\"\n")
  foreach(kind IN LISTS KINDS)
    string(APPEND calls "  wrong += differences<kinds::${kind}>(\"${header}\",
    [](auto one, Numbers& found) { ${header}_on<decltype(one)>(found); });\n")
  endforeach()
endforeach()
foreach(kind IN LISTS KINDS)
  string(APPEND kinds "#include \"kinds/${kind}.h\"\n")
endforeach()

if(MACROS)
  list(REMOVE_DUPLICATES needed)
  list(JOIN needed "\n" needed)
  file(READ ${MACROS} macros)
  string(REGEX MATCHALL "#define [A-Za-z0-9]+" undone "${macros}")
  list(TRANSFORM undone REPLACE "#define" "#undef")
  list(JOIN undone "\n" undone)
  set(includes "${needed}\n#include \"${MACROS}\"\n${includes}${undone}\n")
endif()

# The headers first and nothing before them: each must bring all that it needs.
file(WRITE ${SCRATCH}/program.cpp "${includes}
${kinds}${adapters}
int main() {
  int wrong = 0;
${calls}  return wrong > 0;
}
")

set(eigen)
if(EIGEN)
  set(eigen -isystem ${EIGEN})
endif()
execute_process(
  COMMAND ${COMPILER} -std=c++${STANDARD} -I${CMAKE_CURRENT_LIST_DIR} ${eigen} -Wall -Wextra
          -Wpedantic -Wconversion -Wshadow -Werror -fno-exceptions -fno-rtti ${FLAGS} program.cpp
          -o program
  WORKING_DIRECTORY ${SCRATCH} RESULT_VARIABLE result ERROR_VARIABLE errors)
if(result)
  message(FATAL_ERROR "${SCRATCH}/program.cpp does not compile:\n${errors}")
endif()
execute_process(COMMAND ${SCRATCH}/program RESULT_VARIABLE result OUTPUT_VARIABLE output)
if(result)
  message(FATAL_ERROR "${SCRATCH}/program.cpp: not the same numbers (${result})\n${output}")
endif()
