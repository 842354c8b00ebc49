# SPDX-License-Identifier: MIT-0
# Puts what students get into a folder and zips it: the book, the headers, the exercises without their answers, and the grader, compiled.
# cmake -DSOURCE=repository -DBUILD=build -DGXX=g++ -DNODE=node -DOUT=build/one-step-at-a-time.zip -P handout.cmake
cmake_path(GET OUT PARENT_PATH into)
cmake_path(GET OUT STEM name)
set(top ${into}/handout/${name})
file(REMOVE_RECURSE ${into}/handout)
file(COPY ${SOURCE}/LICENSE ${SOURCE}/code ${SOURCE}/exercises/handout/README.md DESTINATION ${top})
# A container for systems on which the grader is no program.
file(COPY ${SOURCE}/exercises/handout/devcontainer/ DESTINATION ${top}/.devcontainer)
file(COPY ${BUILD}/book DESTINATION ${top} PATTERN *.pdf EXCLUDE)
# Where the book has been printed, its front page leads to the PDF.
file(READ ${top}/book/index.html front)
string(REGEX REPLACE "<p class=\"pdf\">[^\n]*\n" "" front "${front}")
file(WRITE ${top}/book/index.html "${front}")
# For editors: where given.h is, and that a header is C++.
file(COPY ${SOURCE}/exercises/handout/compile_flags.txt DESTINATION ${top})
file(COPY ${SOURCE}/exercises/handout/vscode/ DESTINATION ${top}/.vscode)

# Of an exercise its text, its starter, and how it is called.
file(GLOB handed RELATIVE ${SOURCE} ${SOURCE}/exercises/*/*/task.md ${SOURCE}/exercises/*/*/starter.h
  ${SOURCE}/exercises/*/*/harness.h)
foreach(file IN LISTS handed)
  cmake_path(GET file PARENT_PATH folder)
  file(COPY ${SOURCE}/${file} DESTINATION ${top}/${folder})
endforeach()

# Of the grader its program, which holds the tests, where the book says that it is; and what it makes its kit of, when it first
# runs, with the student's own compiler.
file(COPY ${SOURCE}/exercises/grader/bwrap.apparmor ${SOURCE}/exercises/grader/harness DESTINATION ${top}/exercises/grader)
set(built ${top}/build/exercises)
file(COPY ${BUILD}/exercises/grade ${BUILD}/exercises/installed.txt DESTINATION ${built})
set(kit exercises/grader/kit)
foreach(part IN ITEMS canary limited run.bpf check.bpf compile.bpf)
  file(COPY ${BUILD}/${kit}/${part} DESTINATION ${top}/build/${kit})
endforeach()
foreach(file IN LISTS handed)
  if(file MATCHES "exercises/(.*/([^/]*))/task[.]md$")
    file(MAKE_DIRECTORY ${built}/ways)
    execute_process(COMMAND ${BUILD}/exercises/grade seal ${CMAKE_MATCH_1} OUTPUT_FILE ${built}/ways/${CMAKE_MATCH_2}.sealed
      COMMAND_ERROR_IS_FATAL ANY)
  endif()
endforeach()
include(${SOURCE}/exercises/handout/licences.cmake)
put_licences(${built}/licences)

execute_process(COMMAND ${NODE} ${SOURCE}/book/publish/zip.mjs ${top} ${OUT}.new COMMAND_ERROR_IS_FATAL ANY)
file(RENAME ${OUT}.new ${OUT})
file(REMOVE_RECURSE ${into}/handout)
