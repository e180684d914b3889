# The compile flags, each with its reason.
#
# carom_flags       goes with the installed package: everything that changes the layout of an Eigen object or
#                   the order of a sum must be the same in the library and in the program that uses it.
# carom_own_flags   only for our own targets: warnings and optimisation.

find_package(Eigen3 3.4 REQUIRED NO_MODULE)

add_library(carom_flags INTERFACE)
add_library(carom::flags ALIAS carom_flags)
set_target_properties(carom_flags PROPERTIES EXPORT_NAME flags)
target_compile_features(carom_flags INTERFACE cxx_std_20)
target_link_libraries(carom_flags INTERFACE Eigen3::Eigen)
target_compile_definitions(carom_flags INTERFACE
  EIGEN_DONT_VECTORIZE            # one order of summation: the same bits for every lane width and compiler
  EIGEN_FAST_MATH=0               # exact square roots
  EIGEN_MAX_STATIC_ALIGN_BYTES=16 # one layout whatever -march says
)
# A fused multiply-add rounds once where the written formula rounds twice: results would depend on the machine.
target_compile_options(carom_flags INTERFACE $<$<CXX_COMPILER_ID:GNU,Clang,AppleClang>:-ffp-contract=off>)

add_library(carom_own_flags INTERFACE)
target_link_libraries(carom_own_flags INTERFACE carom_flags)
target_compile_options(carom_own_flags INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion -Wnon-virtual-dtor
  -Wno-ignored-attributes -Wno-psabi
  # g++ 12 takes "text" + std::string for overlapping copies (its bug 105651).
  $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>
  -fno-math-errno                 # lets sqrt be one instruction; no result changes
  $<$<BOOL:${CAROM_WERROR}>:-Werror>)

# carom_compile_fast(<target>): for code that waits for files, tests and people. Optimising it takes most of the time of
# a build and saves none afterwards.
function(carom_compile_fast target)
  target_compile_options(${target} PRIVATE $<$<NOT:$<CONFIG:Debug>>:-O1>)
endfunction()

# The course links a program for every answer: the linker that comes with binutils beside the usual one takes a third of
# its time.
set(CAROM_LINKER "")
if(PROJECT_IS_TOP_LEVEL AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  include(CheckLinkerFlag)
  check_linker_flag(CXX -fuse-ld=gold CAROM_HAS_GOLD)
  if(CAROM_HAS_GOLD)
    set(CAROM_LINKER -fuse-ld=gold)
    add_link_options(${CAROM_LINKER})
  endif()
endif()

# Eigen at -O2 is half as fast as at -O3, at -O0 80 times slower.
string(REPLACE "-O2" "-O3" CMAKE_CXX_FLAGS_RELWITHDEBINFO "${CMAKE_CXX_FLAGS_RELWITHDEBINFO}")
string(REPLACE "-DNDEBUG" "" CMAKE_CXX_FLAGS_RELWITHDEBINFO "${CMAKE_CXX_FLAGS_RELWITHDEBINFO}")
string(REPLACE "-g" "-g1" CMAKE_CXX_FLAGS_RELWITHDEBINFO "${CMAKE_CXX_FLAGS_RELWITHDEBINFO}")
set(CMAKE_CXX_FLAGS_DEBUG "-Og -g -DEIGEN_INITIALIZE_MATRICES_BY_NAN")
