# A student's copy of the course: `course teach branch` leaves out the library's version of every function whose answer
# does not show yet. The library then takes the student's own file in its place.
#
#   exercises/<chapter>/<seam>.cpp                    the student's
#   exercises/<chapter>/given/<seam>/skeleton.cpp     as it came; stands in where the student's does not compile, and
#                                                     in the place of functions of chapters that come later

file(GLOB CAROM_GIVEN_SKELETONS CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/exercises/*/given/*/skeleton.cpp)
set(CAROM_STUDENT OFF)
if(CAROM_GIVEN_SKELETONS)
  set(CAROM_STUDENT ON)
endif()

# carom_students_seam(<target> <group> <seam> <layer>...): the object library of a seam without a version of our own.
# carom_given_<group>_<seam> is its skeleton, by which is known what the student's file has to define.
function(carom_students_seam target group seam)
  set(given ${CAROM_GIVEN_SKELETONS})
  list(FILTER given INCLUDE REGEX "/given/${seam}/skeleton\\.cpp$")
  if(NOT given)
    message(FATAL_ERROR "there is no ${CMAKE_CURRENT_SOURCE_DIR}/${seam}.cpp, and no exercise that asks for it")
  endif()
  cmake_path(GET given PARENT_PATH folder)
  cmake_path(SET mine NORMALIZE ${folder}/../../${seam}.cpp)
  file(GLOB there CONFIGURE_DEPENDS ${mine})
  set(source ${given})
  if(there)
    set(source ${mine})
  endif()
  function(carom_students_objects name file)
    add_library(${name} OBJECT ${file})
    target_link_libraries(${name} PRIVATE carom_flags ${ARGN})
    target_include_directories(${name} PRIVATE ${PROJECT_SOURCE_DIR}/lib ${CMAKE_CURRENT_SOURCE_DIR})
    set_property(TARGET ${name} PROPERTY POSITION_INDEPENDENT_CODE ON)
  endfunction()
  carom_students_objects(${target} ${source} ${ARGN})
  carom_students_objects(carom_given_${group}_${seam} ${given} ${ARGN})
  set_target_properties(carom_given_${group}_${seam} PROPERTIES EXCLUDE_FROM_ALL ON)
  if(there)
    # One file that does not compile must not stop every other exercise and program.
    set_property(TARGET ${target} PROPERTY CXX_COMPILER_LAUNCHER
      sh ${PROJECT_SOURCE_DIR}/lib/cmake/or_skeleton.sh ${mine} ${given} ${CMAKE_CXX_COMPILER_LAUNCHER})
  endif()
endfunction()

# carom_tell_missing(<program>): when it meets a function that is not written, it names the exercise and ends.
function(carom_tell_missing program)
  if(NOT CAROM_STUDENT)
    return()
  endif()
  if(NOT TARGET carom_missing)
    set(table "")
    foreach(file IN LISTS CAROM_GIVEN_SKELETONS)
      string(REGEX MATCH "/([0-9][0-9])_[^/]*/given/([^/]*)/skeleton.cpp$" found ${file})
      set(id ${CMAKE_MATCH_1}.${CMAKE_MATCH_2})
      set(later true)
      cmake_path(GET file PARENT_PATH folder)
      if(EXISTS ${folder}/exercise.ini)
        set(later false)
      endif()
      file(READ ${file} source)
      string(REGEX MATCHALL "todo<[^(]*>\\(\"[A-Za-z0-9_]+\"" calls "${source}")
      foreach(call IN LISTS calls)
        string(REGEX REPLACE ".*\"([A-Za-z0-9_]+)\"" "\\1" name "${call}")
        string(APPEND table "{\"${name}\", \"${id}\", ${later}},\n")
      endforeach()
    endforeach()
    file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/missing/exercises.inc CONTENT "${table}" @ONLY)
    add_library(carom_missing OBJECT ${PROJECT_SOURCE_DIR}/lib/carom_io/missing.cpp)
    target_link_libraries(carom_missing PRIVATE carom_own_flags)
    target_include_directories(carom_missing PRIVATE ${PROJECT_SOURCE_DIR}/lib ${PROJECT_BINARY_DIR}/missing)
  endif()
  target_sources(${program} PRIVATE $<TARGET_OBJECTS:carom_missing>)
endfunction()
