# Headers that most files include, read once for a build instead of once for each file: a file of tests compiles in
# half the time. Builds whose files must each include what they use, as the release's, leave it out.
#
# playhouse_precompile(TARGET KIND) has the sources of a target begin with those headers; KIND is library or test. The
# target must be compiled with the options of its kind, in Playhouse.cmake.

option(PLAYHOUSE_PRECOMPILE "precompile common headers: faster, but a missing include goes unseen" OFF)
if(NOT PLAYHOUSE_PRECOMPILE)
  function(playhouse_precompile)
  endfunction()
  return()
endif()

if(CMAKE_CXX_COMPILER_ID STREQUAL Clang)  # for ccache, which knows a precompiled header by its content
  add_compile_options("SHELL:-Xclang -fno-pch-timestamp")
endif()

foreach(KIND library test)
  file(GENERATE OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/precompiled_${KIND}.cc CONTENT "")
  add_library(playhouse_precompiled_${KIND} OBJECT ${CMAKE_CURRENT_BINARY_DIR}/precompiled_${KIND}.cc)
  target_precompile_headers(playhouse_precompiled_${KIND} PRIVATE ${CMAKE_CURRENT_LIST_DIR}/precompiled/${KIND}.h)
  target_link_libraries(playhouse_precompiled_${KIND} PRIVATE playhouse_flags fmt::fmt)
endforeach()
target_link_libraries(playhouse_precompiled_test PRIVATE rapidcheck rapidcheck_gtest GTest::gtest GTest::gmock)
playhouse_test_options(playhouse_precompiled_test)

function(playhouse_precompile TARGET KIND)
  target_precompile_headers(${TARGET} REUSE_FROM playhouse_precompiled_${KIND})
endfunction()
