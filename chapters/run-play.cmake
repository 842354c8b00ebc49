# Runs PLAY, which makes FILM, and keeps what it prints beside it. A program of a chapter writes its film into the folder where
# it is run.
get_filename_component(folder ${FILM} DIRECTORY)
get_filename_component(name ${FILM} NAME_WE)
execute_process(COMMAND ${PLAY} WORKING_DIRECTORY ${folder} OUTPUT_FILE ${name}.txt RESULT_VARIABLE result)
if(NOT result EQUAL 0 OR NOT EXISTS ${FILM})
  message(FATAL_ERROR "${PLAY} has made no ${name}.html (${result})")
endif()
