# Compiles a program that calls every function of HEADERS on the vectors of VECTORS, or on the one
# KIND of tests/snippets/kinds, and runs it.
# Its folder holds these headers, and those that they are used WITH, and no other. Without EIGEN,
# Eigen is not to be found. With MACROS, a file of macros, the headers are read after them, and after
# all that they include, which would not survive. FLAGS are the compiler's.
include(${CMAKE_CURRENT_LIST_DIR}/functions.cmake)
string(REPLACE "," ";" HEADERS "${HEADERS}")
string(REPLACE "," ";" WITH "${WITH}")
string(REPLACE "," ";" FLAGS "${FLAGS}")
file(REMOVE_RECURSE ${SCRATCH})
set(includes "")
set(adapters "")
set(calls "")
foreach(header IN LISTS WITH HEADERS)
  file(COPY ${INTEGRATE}/${header}.h DESTINATION ${SCRATCH})
  string(APPEND includes "#include \"${header}.h\"\n")
endforeach()
foreach(header IN LISTS HEADERS)
  calls_of(${INTEGRATE}/${header}.h ${SCRATCH} file)
  string(APPEND adapters "#include \"${file}\"\n")
  string(APPEND calls "  call_${header}(attempt);\n")
endforeach()

if(MACROS)
  set(needed "")
  foreach(header IN LISTS WITH HEADERS)
    cmake_path(ABSOLUTE_PATH header BASE_DIRECTORY ${SCRATCH})
    if(NOT header MATCHES "\\.h$")
      string(APPEND header ".h")
    endif()
    file(STRINGS ${header} lines REGEX "^#include <")
    list(APPEND needed ${lines})
  endforeach()
  list(REMOVE_DUPLICATES needed)
  list(JOIN needed "\n" needed)
  file(READ ${MACROS} macros)
  string(REGEX MATCHALL "#define [A-Za-z0-9]+" undone "${macros}")
  list(TRANSFORM undone REPLACE "#define" "#undef")
  list(JOIN undone "\n" undone)
  set(includes "${needed}\n#include \"${MACROS}\"\n${includes}${undone}\n")
endif()

set(vectors "#include \"${VECTORS}.h\"")
if(KIND)
  set(vectors "#include \"same_steps.h\"
#include \"kinds/${KIND}.h\"
struct Attempt {
  int wrong = 0;

  template <class Method>
  void operator()(const char* name, Method method) {
    wrong += differences<kinds::${KIND}>(name, method);
  }
};")
endif()

# The headers first and nothing before them: each must bring all that it needs.
file(WRITE ${SCRATCH}/program.cpp "${includes}
${vectors}
${adapters}
int main() {
  Attempt attempt;
${calls}  return attempt.wrong > 0;
}
")

set(eigen)
if(EIGEN)
  set(eigen -isystem ${EIGEN})
endif()
# No fused operations, which would round a vector in another way than its coordinates.
execute_process(
  COMMAND ${COMPILER} -std=c++${STANDARD} -I${CMAKE_CURRENT_LIST_DIR} ${eigen} -Wall -Wextra
          -Wpedantic -Wconversion -Wshadow -Werror -fno-exceptions -fno-rtti -ffp-contract=off
          ${FLAGS} program.cpp -o program
  WORKING_DIRECTORY ${SCRATCH} RESULT_VARIABLE result ERROR_VARIABLE errors)
if(result)
  message(FATAL_ERROR "${SCRATCH}/program.cpp does not compile:\n${errors}")
endif()
execute_process(COMMAND ${SCRATCH}/program RESULT_VARIABLE result OUTPUT_VARIABLE output)
if(result)
  message(FATAL_ERROR "${SCRATCH}/program.cpp: not the same steps (${result})\n${output}")
endif()
