# cmake -DPROGRAM=<executable> -DOUTPUT=<folder>/<name>.txt -P run_program.cmake
#
# Runs a chapter program with the folder of OUTPUT to write its pictures in, and keeps what it prints.

get_filename_component(folder ${OUTPUT} DIRECTORY)
file(MAKE_DIRECTORY ${folder})
execute_process(COMMAND ${PROGRAM} ${folder} WORKING_DIRECTORY ${folder}
  OUTPUT_VARIABLE printed ERROR_VARIABLE complaint RESULT_VARIABLE result)
if(NOT result EQUAL 0)
  message(FATAL_ERROR "${PROGRAM} ended with ${result}: ${complaint}")
endif()
if(printed STREQUAL "")
  message(FATAL_ERROR "${PROGRAM} printed nothing for the page to quote")
endif()
file(WRITE ${OUTPUT} "${printed}")
