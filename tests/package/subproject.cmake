# Configures a project that adds this one as a folder. Neither tests nor course may come along, and no library but
# Eigen may be asked for by the layers.
include(${CMAKE_CURRENT_LIST_DIR}/step.cmake)
set(build ${SCRATCH}/subproject)
file(REMOVE_RECURSE ${build})
step(${CMAKE_COMMAND} -S ${CMAKE_CURRENT_LIST_DIR}/subproject -B ${build} -G Ninja -DCAROM=${SOURCE}
  -DCMAKE_CXX_COMPILER=${COMPILER} -DCMAKE_DISABLE_FIND_PACKAGE_Catch2=TRUE)
