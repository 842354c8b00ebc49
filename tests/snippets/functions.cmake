# The file with the calls of a header's functions: the one in calls, or one made in FOLDER, for a
# header whose functions all take (x, v, t, h, acceleration) and need no start.
function(calls_of header folder file)
  get_filename_component(name ${header} NAME_WE)
  set(written ${CMAKE_CURRENT_LIST_DIR}/calls/${name}.h)
  if(EXISTS ${written})
    set(${file} ${written} PARENT_SCOPE)
    return()
  endif()
  functions_of(${header} functions classes)
  set(calls "")
  foreach(signature IN LISTS functions classes)
    if(NOT signature MATCHES
       "^([a-z0-9_]+)\\((Position|Vec)& x, Vec& v, Time t, Real h, Acceleration&& acceleration\\)$")
      message(FATAL_ERROR "tests/snippets/calls/${name}.h is missing: nobody else knows how "
        "integrate::${signature} is called")
    endif()
    string(APPEND calls "  attempt(\"${CMAKE_MATCH_1}\",
      [](auto& x, auto& v, auto t, auto h, auto& acceleration) {
        integrate::${CMAKE_MATCH_1}(x, v, t, h, acceleration);
      });\n")
  endforeach()
  file(WRITE ${folder}/calls/${name}.h "#pragma once

template <class Try>
void call_${name}(Try& attempt) {
${calls}}
")
  set(${file} ${folder}/calls/${name}.h PARENT_SCOPE)
endfunction()

# Lists the functions of a header as "name(parameters)", and its classes by name. What takes nothing
# checks types, and is called by the header alone.
function(functions_of header functions classes)
  file(READ ${header} text)
  string(REGEX REPLACE "\n#ifdef __clang__[^#]*#endif" "" text "${text}")  # only asks for inlining
  string(REGEX MATCHALL "\ntemplate <" templates "${text}")
  string(REGEX MATCHALL "\nstruct " structs "${text}")
  string(REGEX MATCHALL "\nclass [a-zA-Z0-9]+" found_classes "${text}")
  string(REPLACE "[[nodiscard]] " "" text "${text}")
  string(REGEX MATCHALL "\n[a-zA-Z][a-zA-Z0-9<>, ]* [a-z0-9_]+\\([^()]*\\) {" found "${text}")

  set(known ${found} ${found_classes} ${structs})
  list(LENGTH known known_count)
  list(LENGTH templates count)
  if(count EQUAL 0 OR count GREATER known_count)
    message(FATAL_ERROR "${header} has ${count} templates; recognised are only:${known}")
  endif()
  list(TRANSFORM found REPLACE "[ \n]+" " ")
  list(TRANSFORM found REPLACE "^.* ([a-z0-9_]+\\(.*\\)) {$" "\\1")
  list(FILTER found EXCLUDE REGEX "\\(\\)$")
  list(TRANSFORM found_classes REPLACE "\nclass " "")
  set(${functions} "${found}" PARENT_SCOPE)
  set(${classes} "${found_classes}" PARENT_SCOPE)
endfunction()
