# Programs that record, begun one unit in the last place beside their starts: `moved` stands before `code` for the header of a
# state. The methods are those of the build.
function(moved_starts chapter)
  get_property(sources GLOBAL PROPERTY SOURCES_OF_${chapter})
  add_executable(${chapter}.moved ${sources})
  target_include_directories(${chapter}.moved BEFORE PRIVATE ${CMAKE_CURRENT_SOURCE_DIR}/moved)
  target_link_libraries(${chapter}.moved PRIVATE measure)
  target_precompile_headers(${chapter}.moved REUSE_FROM precompiled)
  add_test(NAME "${chapter}: the same printed numbers from starts a last place aside"
    COMMAND ${NODE} --test-reporter=spec ${CMAKE_CURRENT_SOURCE_DIR}/moved.test.mjs
            $<TARGET_FILE:${chapter}.moved> ${PROJECT_SOURCE_DIR}/chapters/${chapter}
            ${PROJECT_BINARY_DIR}/chapters/${chapter}/data ${CMAKE_CURRENT_BINARY_DIR}/${chapter}/moved)
  set_tests_properties("${chapter}: the same printed numbers from starts a last place aside"
    PROPERTIES LABELS "chapters;thorough")
endfunction()
