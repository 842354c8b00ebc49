# SPDX-License-Identifier: MIT-0
# Puts what students get into a folder and zips it: the book, the headers, the exercises without their answers, and the grader, compiled.
# cmake -DSOURCE=repository -DBUILD=build -DGXX=g++ -DNODE=node -DOUT=build/one-step-at-a-time.zip -P handout.cmake
cmake_path(GET OUT PARENT_PATH into)
cmake_path(GET OUT STEM name)
set(top ${into}/handout/${name})
file(REMOVE_RECURSE ${into}/handout)
file(COPY ${SOURCE}/LICENSE ${SOURCE}/setup.sh ${SOURCE}/code DESTINATION ${top})
file(COPY ${SOURCE}/exercises/handout/CMakeLists.txt ${SOURCE}/exercises/handout/CMakePresets.json
          ${SOURCE}/exercises/handout/README.md DESTINATION ${top})
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

# Of the grader its program, which holds the tests, and what the student's own compiler makes a kit of.
set(grader ${SOURCE}/exercises/grader)
file(COPY ${grader}/kit.cmake ${grader}/compiler.cmake ${grader}/bwrap.apparmor ${grader}/harness
  DESTINATION ${top}/exercises/grader)
set(kit ${BUILD}/exercises/grader/kit)
file(COPY ${BUILD}/exercises/grade ${kit}/canary ${kit}/limited ${kit}/run.bpf ${kit}/check.bpf ${kit}/compile.bpf
  DESTINATION ${top}/exercises/grader/compiled)
include(${SOURCE}/exercises/handout/licences.cmake)
put_licences(${top}/exercises/grader/compiled/licences)

execute_process(COMMAND ${NODE} ${SOURCE}/book/publish/zip.mjs ${top} ${OUT}.new COMMAND_ERROR_IS_FATAL ANY)
file(RENAME ${OUT}.new ${OUT})
file(REMOVE_RECURSE ${into}/handout)
