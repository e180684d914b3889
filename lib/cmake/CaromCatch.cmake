# Catch2 3 or 2.13, whichever the machine has. (find_package has no "2 or 3" range that both config files accept.)
find_package(Catch2 3 QUIET CONFIG)
if(NOT Catch2_FOUND)
  unset(Catch2_DIR CACHE)
  find_package(Catch2 2.13 REQUIRED CONFIG)
endif()
include(Catch)
find_package(nlohmann_json 3 REQUIRED)

add_library(carom_catch INTERFACE)
target_include_directories(carom_catch INTERFACE ${PROJECT_SOURCE_DIR}/tests)
target_compile_definitions(carom_catch INTERFACE CAROM_CATCH_MAJOR=${Catch2_VERSION_MAJOR})
if(Catch2_VERSION VERSION_GREATER_EQUAL 3)
  target_link_libraries(carom_catch INTERFACE Catch2::Catch2)
else()
  target_link_libraries(carom_catch INTERFACE Catch2::Catch2)
endif()

# carom_precompiled(<name> LIBRARIES <target>... HEADERS <header>...): headers that many files include, compiled once.
# Others take them with target_precompile_headers(<target> REUSE_FROM <name>).
function(carom_precompiled name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "LIBRARIES;HEADERS")
  file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/pch/${name}.cpp CONTENT "// Only its precompiled header is wanted.\n" @ONLY)
  add_library(${name} OBJECT ${PROJECT_BINARY_DIR}/pch/${name}.cpp)
  target_link_libraries(${name} PRIVATE carom_own_flags ${arg_LIBRARIES})
  target_include_directories(${name} PRIVATE ${PROJECT_SOURCE_DIR}/lib ${PROJECT_SOURCE_DIR}/tests)
  target_precompile_headers(${name} PRIVATE ${arg_HEADERS})
  carom_compile_fast(${name})
endfunction()
carom_precompiled(carom_test_pch LIBRARIES carom_catch nlohmann_json::nlohmann_json
  HEADERS <Eigen/Core> <algorithm> <array> <cmath> <filesystem> <fstream> <functional> <limits> <map> <random> <sstream>
    <string> <vector> <nlohmann/json.hpp> ${PROJECT_SOURCE_DIR}/tests/support/catch.hpp)

# Our own main for every Catch2 program, compiled once. Optimising Catch2's own code gains nothing.
add_library(carom_catch_main OBJECT ${PROJECT_SOURCE_DIR}/tests/support/catch_main.cpp)
target_link_libraries(carom_catch_main PRIVATE carom_catch)
target_compile_features(carom_catch_main PRIVATE cxx_std_20)
target_compile_options(carom_catch_main PRIVATE -O0)

# All programs labelled unit: what is built under sanitizers.
add_custom_target(unit_tests)

# carom_test_program(<name> SOURCES <file>... [LIBRARIES <target>...] [LABELS <label>...])
# A Catch2 program with one ctest entry per TEST_CASE.
function(carom_test_program name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "SOURCES;LIBRARIES;LABELS;DEFINITIONS")
  add_executable(${name} ${arg_SOURCES} $<TARGET_OBJECTS:carom_catch_main>)
  target_link_libraries(${name} PRIVATE carom_own_flags carom_catch nlohmann_json::nlohmann_json ${arg_LIBRARIES})
  carom_compile_fast(${name})
  target_precompile_headers(${name} REUSE_FROM carom_test_pch)
  target_compile_definitions(${name} PRIVATE
    CAROM_SOURCE_DIR="${PROJECT_SOURCE_DIR}" CAROM_CASES_DIR="${PROJECT_SOURCE_DIR}/tests/cases"
    ${arg_DEFINITIONS})
  if("unit" IN_LIST arg_LABELS)
    add_dependencies(unit_tests ${name})
  endif()
  # Sanitizers take ten times as long and more; what hangs is to be told from that.
  set(timeout 300)
  if(CMAKE_CXX_FLAGS MATCHES "-fsanitize")
    set(timeout 1800)
  endif()
  # Listing happens when ctest runs, so that a crashing program does not break the build.
  catch_discover_tests(${name} TEST_PREFIX "${name}: " DISCOVERY_MODE PRE_TEST
    PROPERTIES LABELS "${arg_LABELS}" TIMEOUT ${timeout})
endfunction()

# carom_layer_tests(<layer> <file>...): the unit tests of a layer, linked with that layer's target alone.
function(carom_layer_tests layer)
  carom_test_program(test_${layer} SOURCES ${ARGN} LIBRARIES carom::${layer} LABELS unit)
endfunction()
