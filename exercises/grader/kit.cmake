# What a submission is compiled with, in the cage and here. An index out of range, in the library's containers too, a pointer to
# nothing or a sum that overflows stops the program; these checks need no library of their own.
set(COMMON_FLAGS -std=c++20 -O2 -ffp-contract=off -Wall -Wextra -Wno-unused-parameter
  -D_GLIBCXX_ASSERTIONS -fsanitize=bounds,undefined)
set(STUDENT_FLAGS ${COMMON_FLAGS} -fsanitize-undefined-trap-on-error)
set_property(GLOBAL PROPERTY STUDENT_FLAGS ${STUDENT_FLAGS})
# And for the run that is not scored, in which a checker says what it stops at. With -O2 two checks that are alike would share
# a line. Of classes with virtual functions nothing is checked: for that the checker makes pipes, which the cage does not grant.
set(CHECKED_FLAGS ${COMMON_FLAGS} -O1 -fsanitize=address -fno-sanitize=vptr -fno-sanitize-recover=all -g)

# What the grader reads when it starts, from beside itself: a word and what it is set to on each line, words with `+=` as often
# as there is something to add. What lies in one folder with it is named from where it lies: the folder may be moved or copied.
set(KIT ${PROJECT_BINARY_DIR}/exercises/grader/kit)
set_property(GLOBAL PROPERTY KIT ${KIT})
set(beside_grade ${PROJECT_BINARY_DIR}/exercises)
file(RELATIVE_PATH exercises ${beside_grade} ${PROJECT_SOURCE_DIR}/exercises)
file(RELATIVE_PATH kit ${beside_grade} ${KIT})
set(installed "exercises=${exercises}\nkit=${kit}\n")
foreach(list IN ITEMS STUDENT_FLAGS CHECKED_FLAGS)
  string(TOLOWER ${list} word)
  foreach(value IN LISTS ${list})
    string(APPEND installed "${word}+=${value}\n")
  endforeach()
endforeach()
set(INSTALLED ${beside_grade}/installed.txt)
file(CONFIGURE OUTPUT ${INSTALLED} CONTENT "${installed}" @ONLY)

# What of the kit is made by the compiler of the machine that it grades on. Where students are, `grade` does this by itself.
find_program(GXX g++ HINTS /usr/bin REQUIRED)  # no cache in front of it, as there may be in the PATH
file(REAL_PATH ${GXX} GXX)
add_executable(make_kit kit/main.cpp kit/make_kit.cpp kit/compiler.cpp kit/ask.cpp home/state.cpp installed.cpp report/files.cpp
  printable.cpp untrusted_files.cpp cage/process.cpp cage/process_tree.cpp cage/pipes.cpp cage/spawn.cpp cage/file.cpp cage/exit_status.cpp)
target_include_directories(make_kit PRIVATE .)
set_target_properties(make_kit PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${beside_grade})
file(GLOB harness CONFIGURE_DEPENDS harness/*.h harness/main.cpp)
set(HARNESS ${KIT}/harness/given.h.gch/STUDENT ${KIT}/harness/given.h.gch/CHECKED ${KIT}/harness/harness.o ${KIT}/compiler.txt)
add_custom_command(OUTPUT ${HARNESS}
  COMMAND ${CMAKE_COMMAND} -E make_directory ${KIT}
  COMMAND make_kit ${KIT} ${GXX}
  DEPENDS make_kit ${harness} ${INSTALLED} VERBATIM COMMENT "Compiling what every exercise is given")
