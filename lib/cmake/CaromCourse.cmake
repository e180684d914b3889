# Chapters and exercises: their programs, their graders, and the manifest that tells the runner how to build and
# link a submission.

# carom_program(CHAPTER <NN_name> NAME <program> [USES <layer>...] [SOURCES <file>...] [SEAMS <seam>...])
# A runnable program of a chapter: <program>.cpp in the calling folder, linked with layers and the recorder.
# SEAMS are functions of the chapter itself that an exercise replaces: <seam>.cpp and <seam>.hpp beside it.
function(carom_program)
  cmake_parse_arguments(PARSE_ARGV 0 arg "" "CHAPTER;NAME" "USES;SOURCES;SEAMS")
  set(target ${arg_CHAPTER}_${arg_NAME})
  set(layers ${arg_USES})
  list(TRANSFORM layers PREPEND carom::)
  set(seam_objects "")
  foreach(seam IN LISTS arg_SEAMS)
    if(NOT TARGET carom_seam_${arg_CHAPTER}_${seam})
      carom_seam(${arg_CHAPTER} ${seam} LAYERS ${layers} carom::core)
      carom_seam_object(${arg_CHAPTER} ${seam} object)
      set_property(GLOBAL PROPERTY CAROM_CHAPTER_SEAM_${arg_CHAPTER}_${seam} ${object})
    endif()
    get_property(object GLOBAL PROPERTY CAROM_CHAPTER_SEAM_${arg_CHAPTER}_${seam})
    list(APPEND seam_objects ${object})
  endforeach()
  # The program's own code is an object library, so that `course play` can link it with other functions.
  add_library(${target}_objects OBJECT ${arg_NAME}.cpp ${arg_SOURCES})
  carom_reads_eigen(${target}_objects)
  target_link_libraries(${target}_objects PRIVATE carom_own_flags ${layers} carom::io)
  add_executable(${target} $<TARGET_OBJECTS:${target}_objects> ${seam_objects})
  target_link_libraries(${target} PRIVATE carom_own_flags ${layers} carom::io)
  carom_tell_missing(${target})
  set_target_properties(${target} PROPERTIES
    OUTPUT_NAME ${arg_NAME} RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/programs/${arg_CHAPTER})
  set_property(GLOBAL APPEND PROPERTY CAROM_PROGRAMS ${arg_CHAPTER}/${arg_NAME})
  set_property(GLOBAL APPEND PROPERTY CAROM_PROGRAM_TARGETS ${target})
  set_property(GLOBAL PROPERTY CAROM_PROGRAM_SEAMS_${arg_CHAPTER}/${arg_NAME} ${arg_SEAMS})
  # All layers in the program: those it names, those of the recorder, and what they use.
  set(closure core)
  foreach(layer IN LISTS arg_USES ITEMS rotation mass)
    carom_layer_closure(${layer} below)
    list(APPEND closure ${layer} ${below})
  endforeach()
  list(REMOVE_DUPLICATES closure)
  set_property(GLOBAL PROPERTY CAROM_PROGRAM_LAYERS_${arg_CHAPTER}/${arg_NAME} ${closure})
endfunction()

# Reads `key = value` from the head of an exercise.ini (not from its sections).
function(carom_ini file key out)
  file(STRINGS ${file} lines REGEX "^${key} = ")
  set(value "")
  if(lines)
    list(GET lines 0 line)
    string(REGEX REPLACE "^${key} = " "" value "${line}")
    string(STRIP "${value}" value)
  endif()
  set(${out} "${value}" PARENT_SCOPE)
endfunction()

# All object files of a layer, without the seams and files named in `without`.
function(carom_layer_objects layer without out)
  set(objects "")
  get_property(seams GLOBAL PROPERTY CAROM_SEAMS_${layer})
  foreach(seam IN LISTS seams)
    if(NOT seam IN_LIST without)
      list(APPEND objects $<TARGET_OBJECTS:carom_seam_${layer}_${seam}>)
    endif()
  endforeach()
  get_property(sources GLOBAL PROPERTY CAROM_HAS_SOURCES_${layer})
  if(sources)
    set(all $<TARGET_OBJECTS:carom_objects_${layer}>)
    foreach(name IN LISTS without)
      set(all "$<FILTER:${all},EXCLUDE,/${name}\\.cpp\\.o$>")
    endforeach()
    list(APPEND objects ${all})
  endif()
  set(${out} "${objects}" PARENT_SCOPE)
endfunction()

# carom_exercise(<folder of exercise.ini>): everything that grades one exercise.
#
#   <x>_test    the Catch2 tests, compiled once
#   grader_<x>  the trusted program: the tests, linked with a proxy that asks through the pipe
#   <x>_child   what a submission is linked with to answer the pipe
#   stage_<x>   the library that an answer may use: the layers below, and its own layer without the answer
#
# Where the student writes test cases (kind test), grader_<x> is only a name for what a check needs: the cases are
# linked with the proxy of the function they are about, and its versions are children.
function(carom_exercise folder)
  set(ini ${folder}/exercise.ini)
  set_property(DIRECTORY ${PROJECT_SOURCE_DIR} APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${ini})
  get_filename_component(name ${folder} NAME)
  # solutions/<chapter>/<name>, or in a student's copy exercises/<chapter>/given/<name>.
  get_filename_component(chapter_folder ${folder} DIRECTORY)
  string(REGEX REPLACE "/given$" "" chapter_folder ${chapter_folder})
  get_filename_component(chapter ${chapter_folder} NAME)
  foreach(key id kind layer home without geometry tests)
    carom_ini(${ini} ${key} ${key})
  endforeach()
  string(REPLACE " " ";" without "${without}")
  set(x ${chapter}_${name})
  set(graders ${PROJECT_SOURCE_DIR}/tests/graders/${chapter})
  set(test_source ${graders}/${name}_test.cpp)
  set(seam ${name})
  set(seam_source ${graders}/${name}_seam.cpp)
  # An exercise that is still being written must not stop the build of all others; `dev check` complains of it.
  if(kind STREQUAL "predict")
    set(required ${test_source})
  elseif(kind STREQUAL "test")
    # The function that the cases are about is the seam of another exercise, 03.sat_boxes.
    string(REGEX REPLACE "^.*\\." "" seam "${tests}")
    string(SUBSTRING "${tests}__" 0 2 tested_chapter)
    file(GLOB seam_source ${PROJECT_SOURCE_DIR}/tests/graders/${tested_chapter}_*/${seam}_seam.cpp)
    if(NOT seam_source)
      message(WARNING "exercise ${id} is left out: 'tests = ${tests}' names no exercise with a function")
      return()
    endif()
    set(required "")
  else()
    set(required ${test_source} ${seam_source})
  endif()
  foreach(file IN LISTS required)
    if(NOT EXISTS ${file})
      message(WARNING "exercise ${id} is left out: there is no ${file}")
      return()
    endif()
  endforeach()
  string(REGEX REPLACE ".*/" "" group "${home}")
  if(NOT kind STREQUAL "predict" AND NOT TARGET carom_seam_${group}_${seam})
    message(WARNING "exercise ${id} is left out: ${home} declares no seam ${seam}")
    return()
  endif()

  set(layer_targets carom::core)
  carom_layer_closure(${layer} closure)
  foreach(used IN LISTS closure ITEMS ${layer})
    if(TARGET carom_${used})
      list(APPEND layer_targets carom::${used})
    endif()
  endforeach()
  set(includes ${PROJECT_SOURCE_DIR}/lib ${PROJECT_SOURCE_DIR}/${home} ${PROJECT_SOURCE_DIR}/tests)

  function(carom_exercise_object target source pch)
    add_library(${target} OBJECT EXCLUDE_FROM_ALL ${source})
    target_link_libraries(${target} PRIVATE carom_own_flags carom_catch)
    target_include_directories(${target} PRIVATE ${includes})
    target_compile_definitions(${target} PRIVATE ${ARGN})
    carom_compile_fast(${target})
    target_precompile_headers(${target} REUSE_FROM ${pch})
  endfunction()

  if(NOT kind STREQUAL "test")
    carom_exercise_object(${x}_test ${test_source} carom_test_pch)
  endif()
  if(kind STREQUAL "predict")
    add_executable(grader_${x} EXCLUDE_FROM_ALL $<TARGET_OBJECTS:${x}_test> $<TARGET_OBJECTS:carom_grading>
                   $<TARGET_OBJECTS:carom_catch_main>)
    target_link_libraries(grader_${x} PRIVATE carom_own_flags carom_catch ${layer_targets})
    set(link_objects "")
    set(trusted $<TARGET_FILE:grader_${x}>)
    add_dependencies(graders grader_${x})
    set(entry_extra "")
  else()
    carom_exercise_object(${x}_proxy ${seam_source} carom_seam_pch CAROM_SEAM_PROXY)
    carom_exercise_object(${x}_child ${seam_source} carom_seam_pch CAROM_SEAM_CHILD)

    # What the answer has to define is known from the library's version, or where that is kept back from the skeleton.
    set(library carom_seam_${group}_${seam})
    if(TARGET carom_given_${group}_${seam})
      set(library carom_given_${group}_${seam})
    endif()
    # The stage: what the answer may stand on.
    set(stage_objects $<TARGET_OBJECTS:carom_variant_library>)
    foreach(used IN LISTS closure ITEMS ${layer})
      if(TARGET carom_${used})
        carom_layer_objects(${used} "${seam};${without}" objects)
        list(APPEND stage_objects ${objects})
      endif()
    endforeach()
    add_library(stage_${x} STATIC EXCLUDE_FROM_ALL ${stage_objects})
    set_target_properties(stage_${x} PROPERTIES LINKER_LANGUAGE CXX)

    if(kind STREQUAL "test")
      add_custom_target(grader_${x} DEPENDS carom_tester carom_catch_main ${x}_proxy carom_course_test_pch)
      set(own_entry "
      \"proxy_objects\": [\"$<JOIN:$<TARGET_OBJECTS:${x}_proxy>,\",\">\"]")
      set(trusted "")
    else()
      add_executable(grader_${x} EXCLUDE_FROM_ALL $<TARGET_OBJECTS:${x}_test> $<TARGET_OBJECTS:${x}_proxy>
                     $<TARGET_OBJECTS:carom_grading> $<TARGET_OBJECTS:carom_catch_main>)
      target_link_libraries(grader_${x} PRIVATE carom_own_flags carom_catch stage_${x})
      set(own_entry "
      \"test_objects\": [\"$<JOIN:$<TARGET_OBJECTS:${x}_test>,\",\">\"]")
      set(trusted $<TARGET_FILE:grader_${x}>)
    endif()
    add_dependencies(graders grader_${x})

    add_dependencies(grader_${x} ${x}_child carom_serve ${library} stage_${x} carom_course_pch)
    set(entry_extra ",${own_entry},
      \"child_objects\": [\"$<JOIN:$<TARGET_OBJECTS:${x}_child>,\",\">\"],
      \"library_object\": \"$<TARGET_OBJECTS:${library}>\",
      \"stage\": \"$<TARGET_FILE:stage_${x}>\"")
    # The student's file in compile_commands.json, so that editors understand it. Never part of the default build.
    if(EXISTS ${PROJECT_SOURCE_DIR}/exercises/${chapter}/${name}.cpp)
      add_library(exercise_${x} OBJECT EXCLUDE_FROM_ALL ${PROJECT_SOURCE_DIR}/exercises/${chapter}/${name}.cpp)
      target_link_libraries(exercise_${x} PRIVATE carom_flags)
      if(kind STREQUAL "test")
        target_link_libraries(exercise_${x} PRIVATE carom_catch)
      endif()
      target_include_directories(exercise_${x} PRIVATE ${PROJECT_SOURCE_DIR}/lib ${PROJECT_SOURCE_DIR}/${home})
    endif()
  endif()
  # cmake --build build/default --target check_<id>
  add_custom_target(check_${id} COMMAND carom_runner --root ${PROJECT_SOURCE_DIR} --build ${PROJECT_BINARY_DIR}
                    --plain check ${id} USES_TERMINAL DEPENDS grader_${x} VERBATIM)

  set(no_geometry false)
  if(geometry STREQUAL "none")
    set(no_geometry true)
  endif()
  set_property(GLOBAL APPEND_STRING PROPERTY CAROM_MANIFEST_EXERCISES "
    \"${id}\": {
      \"target\": \"grader_${x}\",
      \"trusted\": \"${trusted}\",
      \"home\": \"${PROJECT_SOURCE_DIR}/${home}\",
      \"no_geometry\": ${no_geometry}${entry_extra}
    },")
endfunction()

# How a submission is compiled, beside the exported flags: optimised a little, with the library's own range checks on.
# A precompiled header of what nearly every answer includes takes a compilation from a second to a tenth.
function(carom_submission_flags)
  set(base -std=c++20 ${CAROM_LINKER})
  if(CMAKE_CXX_FLAGS)
    separate_arguments(more NATIVE_COMMAND "${CMAKE_CXX_FLAGS}")
    list(APPEND base ${more})
  endif()
  set_property(GLOBAL PROPERTY CAROM_BASE_FLAGS ${base})
  set(code -O1 -g1 -fPIC -D_GLIBCXX_ASSERTIONS)
  # Templates and constant expressions that compute for ever end here, long before the limits on time and memory.
  set(compile_limits -ftemplate-depth=512 -fconstexpr-ops-limit=4000000)
  if(CMAKE_CXX_COMPILER_ID MATCHES Clang)
    set(compile_limits -ftemplate-depth=512 -fconstexpr-steps=4000000)
  endif()
  # carom_course_header(<target> <file> <flags> <more text>): a header in front of every submission of a kind.
  function(carom_course_header target file flags more)
    set(header ${PROJECT_BINARY_DIR}/course_pch/${file})
    file(GENERATE OUTPUT ${header} CONTENT "// Included in front of every submission.
#include <array>
#include <cmath>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include \"carom/core/real.hpp\"
${more}")
    add_custom_command(OUTPUT ${header}.gch
      COMMAND ${CMAKE_CXX_COMPILER} ${base} $<TARGET_PROPERTY:carom_flags,INTERFACE_COMPILE_OPTIONS>
        "-D$<JOIN:$<TARGET_PROPERTY:carom_flags,INTERFACE_COMPILE_DEFINITIONS>,;-D>" ${code} ${flags}
        -I${PROJECT_SOURCE_DIR}/lib
        -isystem "$<JOIN:$<TARGET_PROPERTY:Eigen3::Eigen,INTERFACE_INCLUDE_DIRECTORIES>,;-isystem;>"
        -x c++-header ${header} -o ${header}.gch
      DEPENDS ${header} ${PROJECT_SOURCE_DIR}/lib/carom/core/real.hpp ${ARGN}
      COMMENT "Precompiling what answers include" COMMAND_EXPAND_LISTS VERBATIM)
    add_custom_target(${target} DEPENDS ${header}.gch)
    set(flags ${code} ${flags} ${compile_limits} -include ${header} -Wall -Wextra -Wno-ignored-attributes
        -Wno-psabi -Wno-unused-parameter -fdiagnostics-color=never)
    set_property(GLOBAL PROPERTY ${target} ${flags})
  endfunction()
  carom_course_header(carom_course_pch course.hpp "" "")
  # Test cases are written with what the project's own are written with. Catch2 may lie in /usr/include, which must
  # stay behind the compiler's own folders.
  set(catch_header ${PROJECT_SOURCE_DIR}/tests/support/catch.hpp)
  set(test_flags -I${PROJECT_SOURCE_DIR}/tests -DCAROM_CATCH_MAJOR=${Catch2_VERSION_MAJOR})
  get_target_property(catch_folders Catch2::Catch2 INTERFACE_INCLUDE_DIRECTORIES)
  foreach(folder IN LISTS catch_folders)
    list(APPEND test_flags -idirafter ${folder})
  endforeach()
  carom_course_header(carom_course_test_pch course_test.hpp "${test_flags}" "#include \"${catch_header}\"\n" ${catch_header})
endfunction()

# The manifest: one JSON file that says how this build compiles and links. Written when CMake generates.
function(carom_write_manifest)
  get_property(program_targets GLOBAL PROPERTY CAROM_PROGRAM_TARGETS)
  add_dependencies(course_ready ${program_targets})
  if(TARGET carom_cli)
    add_dependencies(course_ready carom_cli)
  endif()
  set(programs "")
  get_property(all_programs GLOBAL PROPERTY CAROM_PROGRAMS)
  foreach(program IN LISTS all_programs)
    string(REPLACE "/" "_" target ${program})
    get_property(seams GLOBAL PROPERTY CAROM_PROGRAM_SEAMS_${program})
    string(REGEX REPLACE "/.*" "" chapter ${program})
    set(seam_entries "")
    foreach(seam IN LISTS seams)
      string(APPEND seam_entries "\"${seam}\": \"$<TARGET_OBJECTS:carom_seam_${chapter}_${seam}>\",")
    endforeach()
    string(REGEX REPLACE ",$" "" seam_entries "${seam_entries}")
    get_property(program_layers GLOBAL PROPERTY CAROM_PROGRAM_LAYERS_${program})
    string(REPLACE ";" "\",\"" program_layers "${program_layers}")
    string(APPEND programs "
    \"${program}\": {
      \"target\": \"${target}\",
      \"executable\": \"$<TARGET_FILE:${target}>\",
      \"objects\": [\"$<JOIN:$<TARGET_OBJECTS:${target}_objects>,\",\">\"],
      \"seams\": {${seam_entries}},
      \"layers\": [\"${program_layers}\"]
    },")
  endforeach()
  string(REGEX REPLACE ",$" "" programs "${programs}")

  set(layer_entries "")
  get_property(layers GLOBAL PROPERTY CAROM_DECLARED_LAYERS)
  foreach(layer IN LISTS layers)
    set(seam_objects "")
    set(layer_objects "")
    get_property(seams GLOBAL PROPERTY CAROM_SEAMS_${layer})
    foreach(seam IN LISTS seams)
      string(APPEND seam_objects "\"${seam}\": \"$<TARGET_OBJECTS:carom_seam_${layer}_${seam}>\",")
    endforeach()
    get_property(sources GLOBAL PROPERTY CAROM_HAS_SOURCES_${layer})
    if(sources)
      set(layer_objects "\"$<JOIN:$<TARGET_OBJECTS:carom_objects_${layer}>,\",\">\"")
    endif()
    string(REGEX REPLACE ",$" "" seam_objects "${seam_objects}")
    string(APPEND layer_entries "
    \"${layer}\": {\"seams\": {${seam_objects}}, \"objects\": [${layer_objects}]},")
  endforeach()
  string(REGEX REPLACE ",$" "" layer_entries "${layer_entries}")

  # In a student's copy every program stands on the student's functions, and can name one that is missing.
  set(variant carom_variant_library)
  set(missing "")
  if(CAROM_STUDENT)
    set(variant carom_variant_mine)
  endif()
  if(TARGET carom_missing)
    set(missing ",\"$<TARGET_OBJECTS:carom_missing>\"")
  endif()
  get_property(exercises GLOBAL PROPERTY CAROM_MANIFEST_EXERCISES)
  string(REGEX REPLACE ",$" "" exercises "${exercises}")
  set(catch_library "")
  if(Catch2_VERSION_MAJOR GREATER_EQUAL 3)
    set(catch_library "\"$<TARGET_FILE:Catch2::Catch2>\"")
  endif()
  set(cli "")
  if(TARGET carom_cli)
    set(cli $<TARGET_FILE:carom_cli>)
  endif()
  get_property(submission_flags GLOBAL PROPERTY carom_course_pch)
  get_property(test_flags GLOBAL PROPERTY carom_course_test_pch)
  get_property(all_flags GLOBAL PROPERTY CAROM_BASE_FLAGS)
  string(REPLACE ";" "\",\"" submission_flags "${submission_flags}")
  string(REPLACE ";" "\",\"" test_flags "${test_flags}")
  string(REPLACE ";" "\",\"" all_flags "${all_flags}")
  file(GENERATE OUTPUT ${PROJECT_BINARY_DIR}/course.json CONTENT "{
  \"version\": 1,
  \"compiler\": \"${CMAKE_CXX_COMPILER}\",
  \"compiler_id\": \"${CMAKE_CXX_COMPILER_ID}\",
  \"nm\": \"${CMAKE_NM}\",
  \"cmake\": \"${CMAKE_COMMAND}\",
  \"flags\": [\"${all_flags}\",\"$<JOIN:$<TARGET_PROPERTY:carom_flags,INTERFACE_COMPILE_OPTIONS>,\",\">\"],
  \"submission_flags\": [\"-D$<JOIN:$<TARGET_PROPERTY:carom_flags,INTERFACE_COMPILE_DEFINITIONS>,\",\"-D>\",\"${submission_flags}\"],
  \"test_submission_flags\": [\"-D$<JOIN:$<TARGET_PROPERTY:carom_flags,INTERFACE_COMPILE_DEFINITIONS>,\",\"-D>\",\"${test_flags}\"],
  \"edition\": \"${PROJECT_VERSION}\",
  \"versions\": {\"Eigen\": \"${Eigen3_VERSION}\", \"Catch2\": \"${Catch2_VERSION}\",
    \"nlohmann-json\": \"${nlohmann_json_VERSION}\"},
  \"includes\": [\"${PROJECT_SOURCE_DIR}/lib\"],
  \"system_includes\": [\"$<JOIN:$<TARGET_PROPERTY:Eigen3::Eigen,INTERFACE_INCLUDE_DIRECTORIES>,\",\">\"],
  \"no_geometry_include\": \"${PROJECT_SOURCE_DIR}/tests/grading/no_geometry\",
  \"grading_objects\": [\"$<JOIN:$<TARGET_OBJECTS:carom_grading>,\",\">\",\"$<TARGET_OBJECTS:carom_catch_main>\"],
  \"serve_objects\": [\"$<JOIN:$<TARGET_OBJECTS:carom_serve>,\",\">\"],
  \"tester_objects\": [\"$<JOIN:$<TARGET_OBJECTS:carom_tester>,\",\">\",\"$<TARGET_OBJECTS:carom_catch_main>\"],
  \"catch_libraries\": [${catch_library}],
  \"variant_library\": \"$<TARGET_OBJECTS:${variant}>\",
  \"variant_mine\": \"$<TARGET_OBJECTS:carom_variant_mine>\",
  \"layers\": {${layer_entries}
  },
  \"io_library\": \"$<TARGET_FILE:carom_io>\",
  \"io_links\": [\"-lz\"${missing}],
  \"cli\": \"${cli}\",
  \"programs\": {${programs}
  },
  \"exercises\": {${exercises}
  }
}
")
endfunction()
