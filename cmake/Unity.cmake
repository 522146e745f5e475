# The files of a library, compiled eight at a time: what their headers' templates become is compiled once for the eight.
# For builds that are made once, as those of users and of continuous integration; where a file is changed and compiled
# anew, eight are. A unit should stay below 15 s and 600 MB (tools/compile_times.py): TOGETHER says how many
# files, where eight are too many.
#
# playhouse_unity(TARGET TOGETHER n APART a.cc b.cc ALONE c.cc) has the sources of a target compiled so. Each of those named
# has a name of its own for something that another file of the folder calls the same, or takes as long as eight others:
# APART are eights of their own, ALONE are compiled one at a time.

option(PLAYHOUSE_UNITY "compile the files of a library eight at a time" OFF)

function(playhouse_unity TARGET)
  if(NOT PLAYHOUSE_UNITY)
    return()
  endif()
  cmake_parse_arguments(ARG "" "TOGETHER" "APART;ALONE" ${ARGN})
  if(NOT ARG_TOGETHER)
    set(ARG_TOGETHER 8)
  endif()
  list(TRANSFORM ARG_APART PREPEND ${CMAKE_CURRENT_SOURCE_DIR}/)
  list(TRANSFORM ARG_ALONE PREPEND ${CMAKE_CURRENT_SOURCE_DIR}/)
  get_target_property(SOURCES ${TARGET} SOURCES)
  list(FILTER SOURCES INCLUDE REGEX "[.]cc$")
  list(REMOVE_ITEM SOURCES ${ARG_APART} ${ARG_ALONE})
  playhouse_unity_groups(together ${ARG_TOGETHER} ${SOURCES})
  playhouse_unity_groups(apart ${ARG_TOGETHER} ${ARG_APART})
  set_target_properties(${TARGET} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
endfunction()

function(playhouse_unity_groups NAME SIZE)
  set(COUNT 0)
  foreach(SOURCE ${ARGN})
    math(EXPR GROUP "${COUNT} / ${SIZE}")
    set_source_files_properties(${SOURCE} PROPERTIES UNITY_GROUP ${NAME}_${GROUP})
    math(EXPR COUNT "${COUNT} + 1")
  endforeach()
endfunction()
