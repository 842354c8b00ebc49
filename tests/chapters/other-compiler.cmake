# Programs that record, compiled by the other compiler: in the build, where each source is compiled once, and again only
# when it has changed.
get_target_property(options reproducible INTERFACE_COMPILE_OPTIONS)
get_target_property(definitions reproducible INTERFACE_COMPILE_DEFINITIONS)
list(TRANSFORM definitions PREPEND -D)
set(compile_by_other ${CMAKE_CXX_COMPILER_LAUNCHER} ${OTHER_COMPILER} -std=c++20 -O2 -w ${options} ${definitions}
  -I${PROJECT_SOURCE_DIR}/code -isystem ${EIGEN3_INCLUDE_DIR} "-DRECORDED=\"${RECORDED}\"")

# An object of each source.
function(other_objects out)
  foreach(source IN LISTS ARGN)
    cmake_path(RELATIVE_PATH source BASE_DIRECTORY ${PROJECT_SOURCE_DIR} OUTPUT_VARIABLE name)
    set(object ${CMAKE_CURRENT_BINARY_DIR}/other/${name}.o)
    cmake_path(GET object PARENT_PATH folder)
    file(MAKE_DIRECTORY ${folder})
    add_custom_command(OUTPUT ${object}
      COMMAND ${compile_by_other} -MD -MF ${object}.d -c ${source} -o ${object}
      DEPENDS ${source}
      DEPFILE ${object}.d
      VERBATIM
      COMMENT "Compiling ${name} by the other compiler")
    list(APPEND objects ${object})
  endforeach()
  set(${out} ${objects} PARENT_SCOPE)
endfunction()

get_target_property(sources measure SOURCES)
get_target_property(folder measure SOURCE_DIR)
list(TRANSFORM sources PREPEND ${folder}/)
other_objects(measure_by_other ${sources})

# A test that what a program of these sources writes is what lies in `data`, byte for byte.
function(same_numbers name data)
  other_objects(objects ${ARGN})
  set(program ${CMAKE_CURRENT_BINARY_DIR}/other/${name}.program)
  add_custom_command(OUTPUT ${program}
    COMMAND ${OTHER_COMPILER} ${objects} ${measure_by_other} -o ${program}
    DEPENDS ${objects} ${measure_by_other}
    VERBATIM)
  add_custom_target(${name}.by_other ALL DEPENDS ${program})
  add_test(NAME "${name}: the same numbers from clang++"
    COMMAND ${CMAKE_COMMAND} -DPROGRAM=${program} -DDATA=${data}
            -DSCRATCH=${CMAKE_CURRENT_BINARY_DIR}/${name}/other
            -P ${CMAKE_CURRENT_SOURCE_DIR}/same-numbers.cmake)
  set_tests_properties("${name}: the same numbers from clang++" PROPERTIES LABELS "chapters;thorough")
endfunction()
