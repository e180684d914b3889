# Layers: folders lib/carom/<layer>/ of which each may use only the ones named here. A chapter teaches one layer.
#
# Guard 1: carom_layer() refuses a dependency that the table does not allow.
# Guard 2: the tests of a layer link that layer's target alone (carom_layer_tests).
# Guard 3: a test compares every #include with the same table (tests/layering).

set(CAROM_LAYERS core precision rotation mass detection manifold impulse motion toi broadphase solver world)
set(CAROM_USES_core "")
set(CAROM_USES_precision core)
set(CAROM_USES_rotation core)
set(CAROM_USES_mass rotation precision)
set(CAROM_USES_detection rotation precision)
set(CAROM_USES_manifold detection)
set(CAROM_USES_impulse mass manifold)
set(CAROM_USES_motion mass)
set(CAROM_USES_toi detection motion)
set(CAROM_USES_broadphase detection)
set(CAROM_USES_solver impulse broadphase)
set(CAROM_USES_world solver motion toi)

# All layers that `layer` may use, itself excluded, in `out`.
function(carom_layer_closure layer out)
  set(seen "")
  set(open ${CAROM_USES_${layer}})
  while(open)
    list(POP_FRONT open next)
    if(NOT next IN_LIST seen)
      list(APPEND seen ${next})
      list(APPEND open ${CAROM_USES_${next}})
    endif()
  endwhile()
  set(${out} ${seen} PARENT_SCOPE)
endfunction()

# Nearly every file of the library reads Eigen, which takes most of the time of compiling it: it is read once.
# carom_reads_eigen(<target>): its objects take Eigen from the precompiled header.
function(carom_reads_eigen target)
  set_property(TARGET ${target} PROPERTY POSITION_INDEPENDENT_CODE ON)
  if(NOT CAROM_PRECOMPILED)
    return()
  endif()
  if(NOT TARGET carom_eigen_pch)
    file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/pch/carom_eigen_pch.cpp CONTENT "// Only its precompiled header is wanted.\n" @ONLY)
    add_library(carom_eigen_pch OBJECT ${PROJECT_BINARY_DIR}/pch/carom_eigen_pch.cpp)
    target_link_libraries(carom_eigen_pch PRIVATE carom_own_flags)
    target_include_directories(carom_eigen_pch PRIVATE ${PROJECT_SOURCE_DIR}/lib)
    set_property(TARGET carom_eigen_pch PROPERTY POSITION_INDEPENDENT_CODE ON)
    target_precompile_headers(carom_eigen_pch PRIVATE ${PROJECT_SOURCE_DIR}/lib/carom/core/real.hpp)
  endif()
  target_precompile_headers(${target} REUSE_FROM carom_eigen_pch)
  # Of what it read from there g++ 12 forgets that it is the system's, and warns of std::string's own code.
  target_compile_options(${target} PRIVATE
    $<$<CXX_COMPILER_ID:GNU>:-Wno-array-bounds;-Wno-stringop-overflow;-Wno-stringop-overread>)
endfunction()

# carom_headers_alone(<target> <folder> <header>...): a file per header that includes nothing else, compiled only when
# tests ask for it. A header that includes no other of ours must do without Eigen from the precompiled header.
function(carom_headers_alone target folder)
  foreach(kind plain eigen)
    set(files_${kind} "")
  endforeach()
  foreach(header IN LISTS ARGN)
    set(file ${PROJECT_BINARY_DIR}/headers_alone/${folder}/${header}.cpp)
    file(CONFIGURE OUTPUT ${file} CONTENT "#include <${folder}/${header}>\n" @ONLY)
    set(ours "")
    if(EXISTS ${CMAKE_CURRENT_SOURCE_DIR}/${header})
      file(STRINGS ${CMAKE_CURRENT_SOURCE_DIR}/${header} ours REGEX "^#include \"carom/" LIMIT_COUNT 1)
    endif()
    if(ours)
      list(APPEND files_eigen ${file})
    else()
      list(APPEND files_plain ${file})
    endif()
  endforeach()
  if(NOT TARGET carom_headers_alone)
    add_custom_target(carom_headers_alone)
  endif()
  foreach(kind plain eigen)
    if(files_${kind})
      set(objects ${target}_headers_${kind})
      add_library(${objects} OBJECT EXCLUDE_FROM_ALL ${files_${kind}})
      target_link_libraries(${objects} PRIVATE carom_own_flags ${target})
      if(kind STREQUAL "eigen")
        carom_reads_eigen(${objects})
      endif()
      add_dependencies(carom_headers_alone ${objects})
    endif()
  endforeach()
endfunction()

# carom_layer(NAME <layer> [USES <layer>...] [SEAMS <seam>...] [SOURCES <file.cpp>...] [HEADERS <file.hpp>...])
#
# Declares the layer that lives in the calling folder. A seam `x` is a function that an exercise replaces: it
# stands alone in x.cpp beside x.hpp and becomes its own object library, so that a variant of the library can
# take it from another file. Headers of seams need not be listed.
function(carom_layer)
  cmake_parse_arguments(PARSE_ARGV 0 arg "" "NAME" "USES;SEAMS;SOURCES;HEADERS")
  if(arg_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "carom_layer(${arg_NAME}): unknown arguments ${arg_UNPARSED_ARGUMENTS}")
  endif()
  if(NOT arg_NAME IN_LIST CAROM_LAYERS)
    message(FATAL_ERROR "carom_layer: '${arg_NAME}' is not in the table of layers (lib/cmake/CaromLayers.cmake)")
  endif()
  foreach(used IN LISTS arg_USES)
    if(NOT used IN_LIST CAROM_USES_${arg_NAME})
      message(FATAL_ERROR
        "layer '${arg_NAME}' asks for '${used}', but may use only: ${CAROM_USES_${arg_NAME}}. "
        "A layer includes only earlier layers; the table is lib/cmake/CaromLayers.cmake.")
    endif()
  endforeach()

  set(layer_target carom_${arg_NAME})
  set(uses_targets "")
  foreach(used IN LISTS arg_USES)
    list(APPEND uses_targets carom::${used})
  endforeach()

  set(headers ${arg_HEADERS})
  add_library(${layer_target} STATIC)
  add_library(carom::${arg_NAME} ALIAS ${layer_target})
  foreach(seam IN LISTS arg_SEAMS)
    carom_seam(${arg_NAME} ${seam} LAYERS ${uses_targets})
    list(APPEND headers ${seam}.hpp)
    carom_seam_object(${arg_NAME} ${seam} object)
    target_sources(${layer_target} PRIVATE ${object})
  endforeach()
  if(arg_SOURCES)
    add_library(carom_objects_${arg_NAME} OBJECT ${arg_SOURCES})
    target_link_libraries(carom_objects_${arg_NAME} PRIVATE carom_own_flags ${uses_targets})
    target_include_directories(carom_objects_${arg_NAME} PRIVATE ${PROJECT_SOURCE_DIR}/lib)
    carom_reads_eigen(carom_objects_${arg_NAME})
    target_sources(${layer_target} PRIVATE $<TARGET_OBJECTS:carom_objects_${arg_NAME}>)
  endif()
  target_sources(${layer_target} PUBLIC FILE_SET HEADERS BASE_DIRS ${PROJECT_SOURCE_DIR}/lib FILES ${headers})
  target_link_libraries(${layer_target} PUBLIC carom_flags ${uses_targets})
  set_target_properties(${layer_target} PROPERTIES
    EXPORT_NAME ${arg_NAME} LINKER_LANGUAGE CXX)
  carom_headers_alone(${layer_target} carom/${arg_NAME} ${headers})
  install(TARGETS ${layer_target} EXPORT carom ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}
          FILE_SET HEADERS DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})

  set_property(GLOBAL APPEND PROPERTY CAROM_DECLARED_LAYERS ${arg_NAME})
  set_property(GLOBAL PROPERTY CAROM_SEAMS_${arg_NAME} ${arg_SEAMS})
  set_property(GLOBAL PROPERTY CAROM_HAS_SOURCES_${arg_NAME} "${arg_SOURCES}")
endfunction()

# carom_seam(<group> <seam> [LAYERS <layer>...]): the object library of one seam, in the calling folder.
# `group` is the layer, or the chapter for a function that belongs to a chapter's programs.
function(carom_seam group seam)
  cmake_parse_arguments(PARSE_ARGV 2 arg "" "" "LAYERS")
  set(target carom_seam_${group}_${seam})
  add_library(${target} OBJECT ${seam}.cpp)
  target_link_libraries(${target} PRIVATE carom_own_flags ${arg_LAYERS})
  target_include_directories(${target} PRIVATE ${PROJECT_SOURCE_DIR}/lib)
  carom_reads_eigen(${target})
endfunction()

# Whether an exercise's file is still as it came: an exercise of the kind "fix" comes with code that runs, and is wrong.
# The skeleton is what exercises/runner/skeleton.cpp cuts; in a copy of the course without solutions nothing is known.
function(carom_is_skeleton file out)
  set(${out} FALSE PARENT_SCOPE)
  get_filename_component(name ${file} NAME_WE)
  get_filename_component(folder ${file} DIRECTORY)
  get_filename_component(chapter ${folder} NAME)
  set(solution ${PROJECT_SOURCE_DIR}/solutions/${chapter}/${name}/${name}.cpp)
  if(EXISTS ${solution})
    execute_process(
      COMMAND sed -e "/^ *\\/\\/# solution/,/^ *\\/\\/# stub/d" -e "/^ *\\/\\/# end/d" -e "s|^\\( *\\)//#. \\{0,1\\}|\\1|"
        -e "s/^ *$//" ${solution}
      OUTPUT_VARIABLE skeleton)
    file(READ ${file} content)
    if("${content}" STREQUAL "${skeleton}")
      set(${out} TRUE PARENT_SCOPE)
    endif()
  endif()
endfunction()

# The object file that provides a seam in this build: the library's own, or, with CAROM_MINE, the student's
# where the exercise has been worked on. A file that still calls todo() has not been, nor one that is as it came.
function(carom_seam_object group seam out)
  set(${out} $<TARGET_OBJECTS:carom_seam_${group}_${seam}> PARENT_SCOPE)
  if(NOT CAROM_MINE)
    return()
  endif()
  file(GLOB mine CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/exercises/*/${seam}.cpp)
  foreach(file IN LISTS mine)
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${file})
    file(STRINGS ${file} unfinished REGEX "todo<.*>\\(")
    carom_is_skeleton(${file} untouched)
    if(NOT unfinished AND NOT untouched)
      message(STATUS "mine: ${group}/${seam} comes from ${file}")
      set(mine_target carom_mine_${group}_${seam})
      add_library(${mine_target} OBJECT ${file})
      target_link_libraries(${mine_target} PRIVATE carom_flags)
      target_include_directories(${mine_target} PRIVATE ${PROJECT_SOURCE_DIR}/lib ${CMAKE_CURRENT_SOURCE_DIR})
      set(${out} $<TARGET_OBJECTS:${mine_target}> PARENT_SCOPE)
    endif()
  endforeach()
endfunction()
