# SPDX-License-Identifier: MIT-0
# What students get holds all that they need and nothing that they should find out.
# cmake -DSOURCE=repository -DBUILD=build -DGXX=g++ -DNODE=node -DNAMES=exercises -DCLEAN=some -DGRADED=some -DWORK=folder -P handout.cmake
set(zip ${WORK}/one-step-at-a-time.zip)
file(REMOVE_RECURSE ${WORK})
execute_process(COMMAND ${CMAKE_COMMAND} -DSOURCE=${SOURCE} -DBUILD=${BUILD} -DGXX=${GXX} -DNODE=${NODE} -DOUT=${zip}
  -P ${SOURCE}/exercises/handout/handout.cmake COMMAND_ERROR_IS_FATAL ANY)
file(ARCHIVE_EXTRACT INPUT ${zip} DESTINATION ${WORK})
set(top ${WORK}/one-step-at-a-time)

set(wanted README.md LICENSE compile_flags.txt .vscode/c_cpp_properties.json .devcontainer/Dockerfile book/index.html
  code/integrate/euler.h exercises/grader/harness/given.h
  build/exercises/grade build/exercises/licences/README.md build/exercises/licences/libc6-dev.txt)
foreach(name IN LISTS NAMES)
  foreach(file task.md starter.h harness.h)
    list(APPEND wanted exercises/${name}/${file})
  endforeach()
endforeach()
foreach(file IN LISTS wanted)
  if(NOT EXISTS ${top}/${file})
    message(SEND_ERROR "the handout lacks ${file}")
  endif()
endforeach()

file(GLOB_RECURSE all RELATIVE ${top} ${top}/*)
foreach(file IN LISTS all)
  if(file MATCHES "solution|judge|(^|/)(right|wrong)/|(^|/)seed" OR
     (file MATCHES "^exercises/[1-9]" AND NOT file MATCHES "/(task\\.md|starter\\.h|harness\\.h)$") OR
     (file MATCHES "^book/source-exercises-" AND NOT file MATCHES "-(starter|given)-h\\.html$"))
    message(SEND_ERROR "the handout has ${file}")
  endif()
endforeach()

# The grader knows the solutions and the mistakes, compiled only.
execute_process(COMMAND ${NODE} ${CMAKE_CURRENT_LIST_DIR}/compiled_only.mjs ${top}/build/exercises ${SOURCE}/exercises
  RESULT_VARIABLE result)
if(NOT result EQUAL 0)
  message(SEND_ERROR "the handout shows what students should find out")
endif()

# An editor that reads compile_flags.txt finds nothing wrong with a fresh starter, here and where it comes from.
function(is_clean folder name)
  execute_process(COMMAND g++ @compile_flags.txt -fsyntax-only ${SOURCE}/exercises/${name}/starter.h
    WORKING_DIRECTORY ${folder} ERROR_VARIABLE said RESULT_VARIABLE result)
  if(NOT result EQUAL 0)
    message(SEND_ERROR "in ${folder} an editor shows errors in the starter of ${name}: ${said}")
  endif()
endfunction()
foreach(name IN LISTS CLEAN)
  is_clean(${top} ${name})
endforeach()
list(GET NAMES 0 first)
is_clean(${SOURCE}/exercises ${first})

# It makes itself ready, and grades as here.
execute_process(COMMAND ${top}/build/exercises/grade check OUTPUT_VARIABLE said RESULT_VARIABLE result)
if(NOT result EQUAL 0 OR NOT said MATCHES "compiler    ok .*memory      ok")
  message(SEND_ERROR "the handout's grader is not ready: ${said}")
endif()
function(is_graded file name wanted)
  execute_process(COMMAND ${top}/build/exercises/grade ${name} ${SOURCE}/exercises/${name}/${file}
    --exit-status verdict OUTPUT_VARIABLE said RESULT_VARIABLE result)
  if(NOT result EQUAL wanted)
    message(SEND_ERROR "${file} of ${name} came back with ${result}: ${said}")
  endif()
endfunction()
foreach(name IN LISTS GRADED)
  is_graded(solution.h ${name} 0)
endforeach()
list(GET GRADED 0 first)
is_graded(starter.h ${first} 1)

# It runs a main of one's own, and names the line that reads beyond an array.
file(WRITE ${WORK}/own.h "#pragma once
#include \"given.h\"
#ifndef GRADING
int main() { std::vector<int> a(2); return a.data()[2]; }
#endif
")
execute_process(COMMAND ${top}/build/exercises/grade run ${WORK}/own.h ERROR_VARIABLE said)
if(NOT said MATCHES "reads outside of the memory that it has, in line 4")
  message(FATAL_ERROR "grade run does not name the line that misuses memory, but says: ${said}")
endif()

# A copy grades by what lies in it, not by the folder that it was copied from.
list(GET NAMES 0 first)
set(copy ${WORK}/copy)
file(COPY ${top}/build ${top}/exercises DESTINATION ${copy})
file(WRITE ${copy}/exercises/${first}/task.md "# Another title\n")
execute_process(COMMAND ${copy}/build/exercises/grade list ${first} OUTPUT_VARIABLE said)
if(NOT said MATCHES "Another title")
  message(SEND_ERROR "a copy of the handout reads another folder's exercises: ${said}")
endif()
file(REMOVE_RECURSE ${copy}/build/exercises/grader/kit/harness ${copy}/exercises/grader/harness)
execute_process(COMMAND ${copy}/build/exercises/grade ${first} ${SOURCE}/exercises/${first}/solution.h
  OUTPUT_VARIABLE said ERROR_VARIABLE said RESULT_VARIABLE result)
if(result EQUAL 0)
  message(SEND_ERROR "a copy of the handout uses another folder's kit: ${said}")
endif()
