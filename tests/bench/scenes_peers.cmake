# The suites of scenes: Carom beside the engines that are found. Bullet (libbullet-dev), ODE (libode-dev) and MuJoCo
# (libmujoco-dev) are in Debian. Box3D and Jolt are not: build and install them from their public repositories, and give
# the folder where they were installed.
set(CAROM_BOX3D_DIR "" CACHE PATH "Where a build of Box3D was installed, for the suites of scenes (optional)")
set(CAROM_JOLT_DIR "" CACHE PATH "Where a build of Jolt was installed, for the suites of scenes (optional)")
set(scenes ${PROJECT_SOURCE_DIR}/tests/scenes)

add_library(carom_scene_rows STATIC EXCLUDE_FROM_ALL scenes_rows.cpp allocations.cpp ${scenes}/engines.cpp)
target_link_libraries(carom_scene_rows PUBLIC carom_bench carom_scenes)
if(TARGET carom::world)
  target_sources(carom_scene_rows PRIVATE ${scenes}/engine_carom.cpp)
  target_link_libraries(carom_scene_rows PUBLIC carom::world)
  target_compile_definitions(carom_scene_rows PUBLIC CAROM_SCENES_WORLD)
endif()

# carom_scene_peer(<name> LIBRARIES <library>... INCLUDES <folder>... OPTIONS <flag>... DEFINITIONS <definition>...)
function(carom_scene_peer name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "LIBRARIES;INCLUDES;OPTIONS;DEFINITIONS")
  carom_bench_peer(scenes_${name} ${PROJECT_SOURCE_DIR}/tests/scenes/engine_${name}.cpp
    OPTIONS -O3 -DNDEBUG ${arg_OPTIONS} LIBRARIES ${arg_LIBRARIES})
  target_include_directories(bench_peer_scenes_${name} SYSTEM PRIVATE ${arg_INCLUDES})
  target_compile_definitions(bench_peer_scenes_${name} PRIVATE ${arg_DEFINITIONS})
  target_link_libraries(carom_scene_rows PUBLIC bench_peer_scenes_${name})
  string(TOUPPER ${name} upper)
  target_compile_definitions(carom_scene_rows PUBLIC CAROM_SCENES_${upper})
endfunction()

if(CAROM_BULLET_INCLUDE AND CAROM_BULLET_COLLISION AND CAROM_BULLET_MATH AND CAROM_BULLET_DYNAMICS)
  carom_scene_peer(bullet LIBRARIES ${bullet_dynamics} INCLUDES ${CAROM_BULLET_INCLUDE}
    DEFINITIONS BT_USE_DOUBLE_PRECISION)
endif()
if(CAROM_ODE_INCLUDE AND CAROM_ODE)
  carom_scene_peer(ode LIBRARIES ${CAROM_ODE} INCLUDES ${CAROM_ODE_INCLUDE})
endif()
find_path(CAROM_MUJOCO_INCLUDE mujoco/mujoco.h NO_CACHE)
find_library(CAROM_MUJOCO mujoco NO_CACHE)
if(CAROM_MUJOCO_INCLUDE AND CAROM_MUJOCO AND EXISTS ${scenes}/engine_mujoco.cpp)
  carom_scene_peer(mujoco LIBRARIES ${CAROM_MUJOCO} INCLUDES ${CAROM_MUJOCO_INCLUDE})
endif()
if(CAROM_BOX3D_DIR)
  find_package(box3d CONFIG REQUIRED PATHS ${CAROM_BOX3D_DIR} NO_DEFAULT_PATH)
  carom_scene_peer(box3d LIBRARIES box3d::box3d)
endif()
if(CAROM_JOLT_DIR)
  # Built by its own CMake as "Distribution"; its configurations have names that ours do not know, and what it is
  # compiled with without exception must be the same in a program that includes its headers.
  find_package(Jolt CONFIG REQUIRED PATHS ${CAROM_JOLT_DIR} NO_DEFAULT_PATH)
  get_target_property(jolt_library Jolt::Jolt IMPORTED_LOCATION_DISTRIBUTION)
  get_target_property(jolt_include Jolt::Jolt INTERFACE_INCLUDE_DIRECTORIES)
  get_target_property(jolt_definitions Jolt::Jolt INTERFACE_COMPILE_DEFINITIONS)
  get_target_property(jolt_options Jolt::Jolt INTERFACE_COMPILE_OPTIONS)
  list(FILTER jolt_definitions EXCLUDE REGEX "[<>]") # what only other configurations have
  carom_scene_peer(jolt LIBRARIES ${jolt_library} INCLUDES ${jolt_include} DEFINITIONS ${jolt_definitions}
    OPTIONS ${jolt_options} -fno-rtti)
endif()

carom_bench_suite(scenes SOURCES scenes_suite.cpp LIBRARIES carom_scene_rows)
carom_bench_suite(accuracy SOURCES accuracy_suite.cpp accuracy_record.cpp LIBRARIES carom_scene_rows)
carom_bench_suite(growth SOURCES growth_suite.cpp LIBRARIES carom_scene_rows)
carom_bench_suite(skip SOURCES skip_suite.cpp LIBRARIES carom_scene_rows)
