# Compiles a program that records with another compiler and compares all that it writes, byte for
# byte.
file(REMOVE_RECURSE ${SCRATCH})
file(MAKE_DIRECTORY ${SCRATCH}/data)
execute_process(COMMAND ${COMPILER} -std=c++20 -O2 -ffp-contract=off -DEIGEN_DONT_VECTORIZE
  -I${SOURCE}/code -isystem ${EIGEN} "-DRECORDED=\"${RECORDED}\"" ${PROGRAM}
  code/measure/eigenvalues.cpp code/measure/record.cpp code/measure/times.cpp -o ${SCRATCH}/program
  WORKING_DIRECTORY ${SOURCE} COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${SCRATCH}/program ${SCRATCH}/data COMMAND_ERROR_IS_FATAL ANY)
file(GLOB files RELATIVE ${SCRATCH}/data ${SCRATCH}/data/*.csv)
if(NOT files)
  message(FATAL_ERROR "the program wrote nothing")
endif()
foreach(file IN LISTS files)
  file(READ ${SCRATCH}/data/${file} other)
  file(READ ${DATA}/${file} here)
  if(NOT other STREQUAL here)
    message(SEND_ERROR "${file} differs between ${DATA} and ${SCRATCH}/data")
  endif()
endforeach()
