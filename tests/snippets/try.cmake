# Compiles a program that calls every function of HEADERS on the vectors of VECTORS, or on the one
# KIND of tests/snippets/kinds, and runs it.
# Its folder holds these headers, and those that they are used WITH, and no other. EIGEN, MACROS and
# FLAGS are those of program.cmake.
include(${CMAKE_CURRENT_LIST_DIR}/functions.cmake)
include(${CMAKE_CURRENT_LIST_DIR}/program.cmake)
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

set(paths ${WITH} ${HEADERS})
list(TRANSFORM paths PREPEND ${SCRATCH}/)
list(TRANSFORM paths APPEND .h)
read_after_macros("${paths}")

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

# No fused operations, which would round a vector in another way than its coordinates.
compile_and_run("steps" -ffp-contract=off)
