# Runs PROGRAM, by EMULATOR if there is one, and compares what it prints with EXPECTED, line by line.
# With COMPILER and FLAGS, PROGRAM is compiled first.
cmake_minimum_required(VERSION 3.25)
if(COMPILER)
  separate_arguments(FLAGS)
  execute_process(COMMAND ${COMPILER} -std=c++20 ${FLAGS} -ffp-contract=off -DEIGEN_DONT_VECTORIZE
    -I${SOURCE}/code -I${SOURCE}/tests -I${SOURCE}/tests/snippets -isystem ${EIGEN} ${SOURCE}/tests/bits/bits.cpp -o ${PROGRAM}
    COMMAND_ERROR_IS_FATAL ANY)
endif()
execute_process(COMMAND ${EMULATOR} ${PROGRAM} OUTPUT_VARIABLE printed COMMAND_ERROR_IS_FATAL ANY)
string(REPLACE "\r" "" printed "${printed}")  # Windows ends lines with it
file(READ ${EXPECTED} expected)
if(printed STREQUAL expected)
  return()
endif()

string(REPLACE "\n" ";" printed "${printed}")
string(REPLACE "\n" ";" expected "${expected}")
set(missing ${expected})
list(REMOVE_ITEM missing ${printed})
list(REMOVE_ITEM printed ${expected})
list(JOIN missing "\n  " missing)
list(JOIN printed "\n  " printed)
message(FATAL_ERROR "tests/bits/bits.txt does not hold what tests/bits/bits.cpp prints\nexpected:\n  ${missing}\nprinted:\n  ${printed}")
