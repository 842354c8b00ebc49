# A newer compiler warns of more. In a tree configured as a reader does it, nothing makes an error of that; nor in the benchmark,
# which is configured only where its libraries are.
file(REMOVE_RECURSE ${SCRATCH})
execute_process(COMMAND ${CMAKE_COMMAND} -S ${SOURCE} --preset build -B ${SCRATCH} -DBOOK=OFF
  WORKING_DIRECTORY ${SOURCE} OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
file(STRINGS ${SCRATCH}/compile_commands.json commands REGEX "\"command\"")
list(LENGTH commands count)
if(count LESS 50)
  message(FATAL_ERROR "only ${count} commands that compile")
endif()
file(STRINGS ${SOURCE}/tests/peers/CMakeLists.txt peers)
foreach(line IN LISTS commands peers)
  if(line MATCHES "-Werror")
    message(FATAL_ERROR "A warning would stop a reader's build: ${line}")
  endif()
endforeach()
