# What of the grader is made by the compiler of the machine that it grades on: the header that every exercise is given, compiled
# before, and the harness; and where all that is. The book's build includes it, and so does the one that students have.
find_program(GXX g++ HINTS /usr/bin REQUIRED)  # no cache in front of it, as there may be in the PATH
file(REAL_PATH ${GXX} GXX)
include(${CMAKE_CURRENT_LIST_DIR}/compiler.cmake)
folders_for(${GXX} SHOWN_TO_COMPILER)

# What a submission is compiled with, in the cage and here. An index out of range, in the library's containers too, a pointer to
# nothing or a sum that overflows stops the program; these checks need no library of their own.
set(COMMON_FLAGS -std=c++20 -O2 -ffp-contract=off -Wall -Wextra -Wno-unused-parameter
  -D_GLIBCXX_ASSERTIONS -fsanitize=bounds,undefined)
set(STUDENT_FLAGS ${COMMON_FLAGS} -fsanitize-undefined-trap-on-error)
set_property(GLOBAL PROPERTY STUDENT_FLAGS ${STUDENT_FLAGS})
# And for the run that is not scored, in which a checker says what it stops at. With -O2 two checks that are alike would share
# a line.
set(CHECKED_FLAGS ${COMMON_FLAGS} -O1 -fsanitize=address -fno-sanitize-recover=all -g)

libraries_for(${GXX} "${CHECKED_FLAGS}" SHOWN_TO_CHECKED)

set(KIT ${PROJECT_BINARY_DIR}/exercises/grader/kit)
set_property(GLOBAL PROPERTY KIT ${KIT})
file(GLOB harness CONFIGURE_DEPENDS ${CMAKE_CURRENT_LIST_DIR}/harness/*.h)
set(copied)
foreach(header IN LISTS harness)
  cmake_path(GET header FILENAME name)
  add_custom_command(OUTPUT ${KIT}/harness/${name}
    COMMAND ${CMAKE_COMMAND} -E make_directory ${KIT}/harness
    COMMAND ${CMAKE_COMMAND} -E copy ${header} ${KIT}/harness/${name}
    DEPENDS ${header} VERBATIM)
  list(APPEND copied ${KIT}/harness/${name})
endforeach()
# The compiler takes the one of the two that was compiled with the flags at hand. A submission can read all of it while it is
# compiled, so it names the files as the cage does, and no folder of this machine.
set(as_in_the_cage ${CMAKE_COMMAND} -E chdir ${KIT} ${GXX} -ffile-prefix-map=${KIT}=/job)
foreach(build IN ITEMS STUDENT CHECKED)
  add_custom_command(OUTPUT ${KIT}/harness/given.h.gch/${build}
    COMMAND ${CMAKE_COMMAND} -E make_directory ${KIT}/harness/given.h.gch
    COMMAND ${as_in_the_cage} ${${build}_FLAGS} -DGRADING -x c++-header harness/given.h -o harness/given.h.gch/${build}
    DEPENDS ${copied} VERBATIM COMMENT "Compiling what every exercise is given")
endforeach()
add_custom_command(OUTPUT ${KIT}/harness/harness.o
  COMMAND ${as_in_the_cage} ${STUDENT_FLAGS} -ffile-prefix-map=${CMAKE_CURRENT_LIST_DIR}/= -c
          ${CMAKE_CURRENT_LIST_DIR}/harness/main.cpp -o harness/harness.o
  DEPENDS ${copied} ${CMAKE_CURRENT_LIST_DIR}/harness/main.cpp VERBATIM COMMENT "Compiling the harness")
set(HARNESS ${KIT}/harness/given.h.gch/STUDENT ${KIT}/harness/given.h.gch/CHECKED ${KIT}/harness/harness.o)

# What the grader reads when it starts, from beside itself: a word and what it is set to on each line, words with `+=` as often
# as there is something to add. What lies in one folder with it is named from where it lies: the folder may be moved or copied.
set(beside_grade ${PROJECT_BINARY_DIR}/exercises)
file(RELATIVE_PATH exercises ${beside_grade} ${PROJECT_SOURCE_DIR}/exercises)
file(RELATIVE_PATH kit ${beside_grade} ${KIT})
set(installed "exercises=${exercises}\nkit=${kit}\ncompiler=${GXX}\n")
foreach(list IN ITEMS STUDENT_FLAGS CHECKED_FLAGS SHOWN_TO_COMPILER SHOWN_TO_CHECKED)
  string(TOLOWER ${list} word)
  foreach(value IN LISTS ${list})
    string(APPEND installed "${word}+=${value}\n")
  endforeach()
endforeach()
file(CONFIGURE OUTPUT ${beside_grade}/installed.txt CONTENT "${installed}" @ONLY)
