# The known wrong ways of each exercise: edits of its solution become headers, and all are compiled into the grader, which tells a
# student whose answers are theirs what they say. The global property `EDITED chapter/name` holds the headers of an exercise.
find_program(NODE node REQUIRED)
set(tools ${CMAKE_CURRENT_LIST_DIR})
add_library(known OBJECT)
target_link_libraries(known PRIVATE grader)
target_include_directories(known PRIVATE ${tools}/grader/harness)
target_compile_definitions(known PRIVATE GRADING)
target_compile_options(known PRIVATE -w)
get_property(exercises GLOBAL PROPERTY EXERCISES)
set(all_edited)
foreach(exercise IN LISTS exercises)
  set(folder ${PROJECT_SOURCE_DIR}/exercises/${exercise})
  set(made ${PROJECT_BINARY_DIR}/exercises/${exercise})
  file(GLOB edits CONFIGURE_DEPENDS ${folder}/wrong/*.txt)
  file(GLOB headers CONFIGURE_DEPENDS ${folder}/wrong/*.h)
  set(edits_and_headers)
  set(edited)
  foreach(edit IN LISTS edits)
    cmake_path(GET edit STEM way)
    list(APPEND edited ${made}/wrong/${way}.h)
    list(APPEND edits_and_headers ${edit} ${made}/wrong/${way}.h)
  endforeach()
  if(edits)
    add_custom_command(OUTPUT ${edited}
      COMMAND ${NODE} ${tools}/apply_edit.mjs ${folder}/solution.h ${edits_and_headers}
      DEPENDS ${tools}/apply_edit.mjs ${folder}/solution.h ${edits} VERBATIM
      COMMENT "Making the mistakes of ${exercise}")
  endif()
  set_property(GLOBAL PROPERTY "EDITED ${exercise}" ${edited})
  list(APPEND all_edited ${edited})
  add_custom_command(OUTPUT ${made}/known.cpp
    COMMAND ${NODE} ${tools}/known.mjs ${made}/known.cpp ${exercise} ${folder}/harness.h ${folder}/solution.h ${headers} ${edited}
    DEPENDS ${tools}/known.mjs ${folder}/harness.h ${folder}/solution.h ${headers} ${edited} VERBATIM)
  target_sources(known PRIVATE ${made}/known.cpp)
endforeach()
add_custom_target(edited DEPENDS ${all_edited})
