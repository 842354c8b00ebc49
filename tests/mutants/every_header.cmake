# Each header of code/integrate and code/shelf has a folder here with a wrong version of it.
file(GLOB headers RELATIVE ${CODE} ${CODE}/integrate/*.h ${CODE}/shelf/*.h)
foreach(header IN LISTS headers)
  cmake_path(GET header STEM name)
  file(GLOB wrong ${CMAKE_CURRENT_LIST_DIR}/${name}/*.txt)
  if(NOT wrong)
    message(SEND_ERROR "code/${header}: nobody has seen a test of it fail; let "
      "tests/mutants/${name} hold a wrong version, and name the test that must see it")
  endif()
endforeach()
