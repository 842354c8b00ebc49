# What the programs have in common that try headers out: ${SCRATCH}/program.cpp, made by COMPILER.

# With MACROS, a file of macros, what the text in the variable `includes` includes is read after them,
# and after all that these headers include, which would not survive.
function(read_after_macros headers)
  if(NOT MACROS)
    return()
  endif()
  set(needed "")
  foreach(header IN LISTS headers)
    file(STRINGS ${header} lines REGEX "^#include <")
    list(APPEND needed ${lines})
  endforeach()
  list(REMOVE_DUPLICATES needed)
  list(JOIN needed "\n" needed)
  file(READ ${MACROS} macros)
  string(REGEX MATCHALL "#define [A-Za-z0-9]+" undone "${macros}")
  list(TRANSFORM undone REPLACE "#define" "#undef")
  list(JOIN undone "\n" undone)
  set(includes "${needed}\n#include \"${MACROS}\"\n${includes}${undone}\n" PARENT_SCOPE)
endfunction()

# Compiles the program, with FLAGS and those given, and runs it, by EMULATOR if there is to be one, and not at
# all if that was not found; it fails if not all `things` are the same. Without EIGEN, Eigen is not to
# be found. Windows runs only what is called .exe.
function(compile_and_run things)
  set(eigen)
  if(EIGEN)
    set(eigen -isystem ${EIGEN})
  endif()
  execute_process(
    COMMAND ${COMPILER} -std=c++${STANDARD} -I${CMAKE_CURRENT_FUNCTION_LIST_DIR} ${eigen} -Wall
            -Wextra -Wpedantic -Wconversion -Wshadow -Wdouble-promotion -Wsign-conversion -Werror
            -fno-exceptions -fno-rtti ${ARGN} ${FLAGS} program.cpp -o program.exe
    WORKING_DIRECTORY ${SCRATCH} RESULT_VARIABLE result ERROR_VARIABLE errors)
  if(result)
    message(FATAL_ERROR "${SCRATCH}/program.cpp does not compile:\n${errors}")
  endif()
  if(DEFINED EMULATOR AND NOT EMULATOR)
    return()
  endif()
  execute_process(COMMAND ${EMULATOR} ${SCRATCH}/program.exe RESULT_VARIABLE result OUTPUT_VARIABLE output)
  if(result)
    message(FATAL_ERROR "${SCRATCH}/program.cpp: not the same ${things} (${result})\n${output}")
  endif()
endfunction()
