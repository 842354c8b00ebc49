# What compiles for Windows, and Wine, which runs the programs. setup.sh brings no Wine, since it takes
# more than a gigabyte.
find_program(GXX_FOR_WINDOWS x86_64-w64-mingw32-g++-posix REQUIRED)
find_program(WINE NAMES wine64 wine PATHS /usr/lib/wine)
if(NOT WINE)
  message(STATUS "Wine is not installed: what the tests compile for Windows is not run")
endif()

# Tests that need Wine share a folder of its own, made before them and removed after. Without it they
# only compile, and need nothing.
set(wine_folder ${CMAKE_CURRENT_BINARY_DIR}/wine)
function(runs_on_windows test)
  if(WINE)
    set_tests_properties(${test} PROPERTIES ENVIRONMENT
      "WINEPREFIX=${wine_folder};WINEDEBUG=-all;WINEDLLOVERRIDES=mscoree,mshtml=" ${ARGN})
  endif()
endfunction()
if(WINE)
  find_program(WINESERVER NAMES wineserver64 wineserver PATHS /usr/lib/wine REQUIRED)
  add_test(NAME "Wine makes its folder" COMMAND ${WINE} wineboot --init)
  add_test(NAME "Wine's folder is removed"
    COMMAND sh -c "'${WINESERVER}' -w; rm -rf '${wine_folder}'")  # -w: when its last service has ended
  runs_on_windows("Wine makes its folder" LABELS thorough FIXTURES_SETUP wine)
  runs_on_windows("Wine's folder is removed" LABELS thorough FIXTURES_CLEANUP wine)
endif()
