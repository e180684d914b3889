# Installs this build to a scratch folder; builds and runs a small project that knows only that folder.
include(${CMAKE_CURRENT_LIST_DIR}/step.cmake)
set(prefix ${SCRATCH}/prefix)
set(outside ${SCRATCH}/outside)
file(REMOVE_RECURSE ${prefix} ${outside})
step(${CMAKE_COMMAND} --install ${BUILD} --prefix ${prefix})
step(${CMAKE_COMMAND} -S ${CMAKE_CURRENT_LIST_DIR}/outside -B ${outside} -G Ninja
  -DCMAKE_PREFIX_PATH=${prefix} -DCMAKE_CXX_COMPILER=${COMPILER} "-DCMAKE_CXX_FLAGS=${FLAGS}"
  -DCMAKE_BUILD_TYPE=Release -DEXPECTED_PREFIX=${prefix} -DEXPECTED_VERSION=${VERSION})
step(${CMAKE_COMMAND} --build ${outside})
step(${outside}/outside)
if(NOT output STREQUAL "i j = (0, 0, 0, 1)\nbox of 12 kg, 1 x 2 x 3 m: 13, 10, 5 kg m^2\n")
  message(FATAL_ERROR "the outside project answers:\n${output}")
endif()

# Nothing in the installed package points back to where it was made.
file(GLOB_RECURSE files ${prefix}/*.cmake ${prefix}/*.hpp)
if(NOT files)
  message(FATAL_ERROR "nothing was installed")
endif()
foreach(file IN LISTS files)
  file(READ ${file} content)
  foreach(place ${SOURCE} ${BUILD})
    string(FIND "${content}" "${place}/" at)
    if(NOT at EQUAL -1 AND NOT place STREQUAL "")
      message(FATAL_ERROR "${file} names ${place}")
    endif()
  endforeach()
endforeach()
