# The book and the README tell their readers to run the chooser: the target that weaves the book makes
# it, and where they say.
execute_process(COMMAND ${NINJA} -C ${BUILD} -t inputs book
  OUTPUT_VARIABLE made RESULT_VARIABLE code ERROR_VARIABLE err)
if(NOT code EQUAL 0)
  message(FATAL_ERROR "ninja does not say what the book is made of: ${err}")
endif()
foreach(page ${CHAPTER} ${README})
  file(READ ${page} text)
  string(REGEX MATCH "build/([^ \n]*/choose) --scene" told "${text}")
  set(path "${CMAKE_MATCH_1}")
  if(NOT told)
    message(SEND_ERROR "${page} does not say how to run the chooser")
  elseif(NOT made MATCHES "(^|\n)${path}\n")
    message(SEND_ERROR "${page} says to run build/${path}, which the book's target does not make")
  endif()
endforeach()
