# Compiles a program that calls every function of HEADERS, from the shelf, on the KINDS of
# tests/snippets/kinds, and runs it. Its folder holds these headers and no other. EIGEN, MACROS and
# FLAGS are those of program.cmake.
include(${CMAKE_CURRENT_LIST_DIR}/program.cmake)
string(REPLACE "," ";" HEADERS "${HEADERS}")
string(REPLACE "," ";" KINDS "${KINDS}")
string(REPLACE "," ";" FLAGS "${FLAGS}")
file(REMOVE_RECURSE ${SCRATCH})
set(includes "")
set(calls "")
set(adapters "")
set(kinds "")
foreach(header IN LISTS HEADERS)
  file(COPY ${SHELF}/${header}.h DESTINATION ${SCRATCH})
  string(APPEND includes "#include \"${header}.h\"\n")
  string(APPEND adapters "#include \"shelf_calls/${header}.h\"\n")
  foreach(kind IN LISTS KINDS)
    string(APPEND calls "  wrong += differences<kinds::${kind}>(\"${header}\",
    [](auto one, Numbers& found) { ${header}_on<decltype(one)>(found); });\n")
  endforeach()
endforeach()
foreach(kind IN LISTS KINDS)
  string(APPEND kinds "#include \"kinds/${kind}.h\"\n")
endforeach()

set(paths ${HEADERS})
list(TRANSFORM paths PREPEND ${SCRATCH}/)
list(TRANSFORM paths APPEND .h)
read_after_macros("${paths}")

# The headers first and nothing before them: each must bring all that it needs.
file(WRITE ${SCRATCH}/program.cpp "${includes}
${kinds}${adapters}
int main() {
  int wrong = 0;
${calls}  return wrong > 0;
}
")

compile_and_run("numbers")
