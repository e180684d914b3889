# cmake -DPROGRAM=<executable> -DOUTPUT=<folder>/<name>.txt -P run_program.cmake
#
# Runs a chapter program with the folder of OUTPUT to write its pictures in, and keeps what it prints. In a student's
# copy of the course (STUDENT is on) a program stands on the student's functions: how it ended is then what the page shows.

get_filename_component(folder ${OUTPUT} DIRECTORY)
file(MAKE_DIRECTORY ${folder})
set(limit "")
if(STUDENT)
  set(limit TIMEOUT 60)
endif()
execute_process(COMMAND ${PROGRAM} ${folder} WORKING_DIRECTORY ${folder} ${limit}
  OUTPUT_VARIABLE printed ERROR_VARIABLE complaint RESULT_VARIABLE result)
if(STUDENT AND NOT result EQUAL 0)
  if(NOT result EQUAL 3)
    set(complaint "The program ended with ${result}: ${complaint}")
  endif()
  set(printed "${complaint}")
elseif(NOT result EQUAL 0)
  message(FATAL_ERROR "${PROGRAM} ended with ${result}: ${complaint}")
endif()
if(printed STREQUAL "")
  message(FATAL_ERROR "${PROGRAM} printed nothing for the page to quote")
endif()
file(WRITE ${OUTPUT} "${printed}")
