# Prints the folders that a cage shows to COMPILER, a line each.
include(${CMAKE_CURRENT_LIST_DIR}/../../../exercises/grade/compiler.cmake)
folders_for(${COMPILER} folders)
foreach(folder IN LISTS folders)
  message("${folder}")
endforeach()
