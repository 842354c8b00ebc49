# Prints the folders that a cage shows to COMPILER, a line each. The build copies both files beside the tests' programs.
include(${CMAKE_CURRENT_LIST_DIR}/compiler.cmake)
folders_for(${COMPILER} folders)
foreach(folder IN LISTS folders)
  message("${folder}")
endforeach()
