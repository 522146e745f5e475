# Headers that most files include, read once for a build instead of once for each file: a file of tests compiles in
# half the time. tools/tidy.py checks that files include what they use of them.
#
# playhouse_precompile(TARGET HEADER) has the sources of a target begin with a header of precompiled/: library, world or
# devices, for tests library_test and so on; vectors is world for modules with VECTORS. The target must be compiled with the options of its kind, in Playhouse.cmake;
# one with other options has the header compiled for itself: playhouse_precompile(TARGET HEADER OWN).

option(PLAYHOUSE_PRECOMPILE "precompile common headers: faster, but the compiler sees no missing include" OFF)
if(NOT PLAYHOUSE_PRECOMPILE)
  function(playhouse_precompile)
  endfunction()
  return()
endif()

if(CMAKE_CXX_COMPILER_ID STREQUAL Clang)  # for ccache, which knows a precompiled header by its content
  add_compile_options("SHELL:-Xclang -fno-pch-timestamp")
endif()

set(PLAYHOUSE_PRECOMPILED_FOLDER ${CMAKE_CURRENT_LIST_DIR}/precompiled)

function(playhouse_precompile TARGET HEADER)
  if(ARGN STREQUAL OWN)
    target_precompile_headers(${TARGET} PRIVATE ${PLAYHOUSE_PRECOMPILED_FOLDER}/${HEADER}.h)
    return()
  endif()
  set(OF playhouse_precompiled_${HEADER})
  if(NOT TARGET ${OF})
    file(GENERATE OUTPUT ${CMAKE_BINARY_DIR}/precompiled_${HEADER}.cc CONTENT "")
    add_library(${OF} OBJECT ${CMAKE_BINARY_DIR}/precompiled_${HEADER}.cc)
    if(HEADER STREQUAL vectors)
      target_precompile_headers(${OF} PRIVATE ${PLAYHOUSE_PRECOMPILED_FOLDER}/world.h)
      playhouse_vector_options(${OF})
    else()
      target_precompile_headers(${OF} PRIVATE ${PLAYHOUSE_PRECOMPILED_FOLDER}/${HEADER}.h)
    endif()
    target_link_libraries(${OF} PRIVATE playhouse_flags fmt::fmt)
    if(HEADER MATCHES test)
      target_link_libraries(${OF} PRIVATE rapidcheck rapidcheck_gtest GTest::gtest GTest::gmock)
      playhouse_test_options(${OF})
    endif()
  endif()
  target_precompile_headers(${TARGET} REUSE_FROM ${OF})
  target_compile_definitions(${TARGET} PRIVATE FMT_SHARED)  # g++ wants the macros that the header was compiled with
endfunction()
