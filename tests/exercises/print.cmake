# SPDX-License-Identifier: MIT-0
# Puts the proofs of all exercises into one table, and prints it.
set(table)
foreach(proof IN LISTS PROOFS)
  file(READ ${proof} text)
  string(APPEND table "${text}\n")
endforeach()
file(WRITE ${OUT} "${table}")
execute_process(COMMAND ${CMAKE_COMMAND} -E cat ${OUT})
