# Chapters and exercises.

# carom_program(CHAPTER <NN_name> NAME <program> [USES <layer>...] [SOURCES <file>...])
# A runnable program of a chapter: <program>.cpp in the calling folder, linked with layers and the recorder.
function(carom_program)
  cmake_parse_arguments(PARSE_ARGV 0 arg "" "CHAPTER;NAME" "USES;SOURCES")
  set(target ${arg_CHAPTER}_${arg_NAME})
  add_executable(${target} ${arg_NAME}.cpp ${arg_SOURCES})
  set(layers ${arg_USES})
  list(TRANSFORM layers PREPEND carom::)
  target_link_libraries(${target} PRIVATE carom_own_flags ${layers} carom::io)
endfunction()

function(carom_write_manifest)
endfunction()
