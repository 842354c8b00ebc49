# A chapter's program must refuse bad input: exit code 2, one line on stderr, nothing on stdout, and
# nothing left behind.
file(REMOVE_RECURSE ${SCRATCH})
file(MAKE_DIRECTORY ${SCRATCH}/empty ${SCRATCH}/blocked/numbers.csv)
file(WRITE ${SCRATCH}/file "")

set(NAME program)
include(${CMAKE_CURRENT_LIST_DIR}/refusal.cmake)

refuses("don't know '--fast'" --fast)
refuses("don't know 'more'" ${SCRATCH}/empty more)
refuses("No such file or directory; name a folder" ${SCRATCH}/missing)
refuses("name a folder" ${SCRATCH}/file)
refuses("can't write" /proc)
refuses("can't write" ${SCRATCH}/blocked)

file(GLOB_RECURSE left LIST_DIRECTORIES false ${SCRATCH}/*.part ${SCRATCH}/*.part* ${SCRATCH}/empty/*)
if(left)
  message(SEND_ERROR "left behind: ${left}")
endif()
