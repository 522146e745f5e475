# The files of a library, compiled eight at a time: what their headers' templates become is compiled once for the eight.
# For builds that are made once, as those of users and of continuous integration; where a file is changed and compiled
# anew, eight are. Eight keep a unit below 15 s and 600 MB (tools/compile_times.py).
#
# playhouse_unity(TARGET ALONE...) has the sources of a target compiled so, but for those named, each of which has a name
# of its own for something that another file of the folder calls the same, or changes what headers mean.

option(PLAYHOUSE_UNITY "compile the files of a library eight at a time" OFF)

function(playhouse_unity TARGET)
  if(NOT PLAYHOUSE_UNITY)
    return()
  endif()
  set_target_properties(${TARGET} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 8)
  set_source_files_properties(${ARGN} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
endfunction()
