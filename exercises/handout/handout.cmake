# SPDX-License-Identifier: MIT-0
# Puts what students get into a folder and zips it: the book, the headers, the exercises without their answers, the grader.
# cmake -DSOURCE=repository -DBOOK=build/book -DOUT=build/one-step-at-a-time.zip -P handout.cmake
cmake_path(GET OUT PARENT_PATH into)
cmake_path(GET OUT STEM name)
set(top ${into}/handout/${name})
file(REMOVE_RECURSE ${into}/handout)
file(COPY ${SOURCE}/LICENSE ${SOURCE}/setup.sh ${SOURCE}/code DESTINATION ${top})
file(COPY ${SOURCE}/exercises/handout/CMakeLists.txt ${SOURCE}/exercises/handout/CMakePresets.json
          ${SOURCE}/exercises/handout/README.md DESTINATION ${top})
file(COPY ${BOOK} DESTINATION ${top})
# For editors: where given.h is, and that a header is C++.
file(COPY ${SOURCE}/exercises/handout/compile_flags.txt DESTINATION ${top})
file(COPY ${SOURCE}/exercises/handout/vscode/ DESTINATION ${top}/.vscode)

# Of an exercise its text, its starter and its tests with their headers; the folders right and wrong lie deeper.
file(COPY ${SOURCE}/exercises/CMakeLists.txt ${SOURCE}/exercises/grader DESTINATION ${top}/exercises)
file(GLOB handed RELATIVE ${SOURCE} ${SOURCE}/exercises/*/*.h ${SOURCE}/exercises/*/*/*.h
  ${SOURCE}/exercises/*/*/task.md ${SOURCE}/exercises/*/*/judge.cpp)
list(FILTER handed EXCLUDE REGEX "/solution\\.h$|^exercises/(grader|handout)/")
foreach(file IN LISTS handed)
  cmake_path(GET file PARENT_PATH folder)
  file(COPY ${SOURCE}/${file} DESTINATION ${top}/${folder})
endforeach()

execute_process(COMMAND ${CMAKE_COMMAND} -E tar cf ${OUT}.new --format=zip ${name}
  WORKING_DIRECTORY ${into}/handout COMMAND_ERROR_IS_FATAL ANY)
file(RENAME ${OUT}.new ${OUT})
file(REMOVE_RECURSE ${into}/handout)
