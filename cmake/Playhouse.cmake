# The build's own vocabulary: flags for every target and playhouse_module(), which declares one module. Needs nothing
# but a compiler and Python, so that the client library can be built alone (clients/cpp/CMakeLists.txt).

get_filename_component(PLAYHOUSE_ROOT ${CMAKE_CURRENT_LIST_DIR}/.. ABSOLUTE)
include(${CMAKE_CURRENT_LIST_DIR}/Codegen.cmake)

find_program(CCACHE ccache)
if(CCACHE)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env CCACHE_SLOPPINESS=pch_defines,time_macros ${CCACHE})
endif()

if(CMAKE_CXX_COMPILER_ID STREQUAL Clang)  # a sanitized program of tests: 0.8 s on average, 1.9 s with binutils' linker
  find_program(LLD ld.lld)
  if(LLD)
    add_link_options(-fuse-ld=lld)
  endif()
endif()

# Each linking notes the files that it read, in link.d beside the objects: tools/packages.py asks whose they are. From 3.27
# on CMake has the linker do so itself.
include(CheckLinkerFlag)
check_linker_flag(CXX "LINKER:--dependency-file=link.d" PLAYHOUSE_LINKER_NOTES_FILES)
if(PLAYHOUSE_LINKER_NOTES_FILES AND CMAKE_VERSION VERSION_LESS 3.27)
  foreach(RULE LINK_EXECUTABLE CREATE_SHARED_LIBRARY CREATE_SHARED_MODULE)
    string(APPEND CMAKE_CXX_${RULE} " -Wl,--dependency-file=<OBJECT_DIR>/link.d")
  endforeach()
endif()

# Warnings are for this folder and those below it: a project that takes this one in as a part chooses its own.
add_compile_options(-Wall -Wextra -Wconversion -Wno-sign-conversion)
if(CMAKE_CXX_COMPILER_ID STREQUAL GNU)
  # g++ 12 sees overlaps and overflows within inlined functions of its own library, and an else in gtest's macros. In a
  # unity build it takes a class of a source for one of a header.
  add_compile_options(-Wno-restrict -Wno-stringop-overflow -Wno-array-bounds -Wno-dangling-else -Wno-subobject-linkage)
endif()
if(PLAYHOUSE_WERROR)
  add_compile_options(-Werror)
endif()
add_compile_options(-fmacro-prefix-map=${PLAYHOUSE_ROOT}/=)  # the program does not name the folder it was built in
if(PLAYHOUSE_SANITIZE)  # the optimiser takes the compiler twice as long; HOT modules have it all the same
  add_compile_options(-O0)
endif()

# What whoever links one of our libraries needs as well.
add_library(playhouse_flags INTERFACE)
target_include_directories(playhouse_flags INTERFACE ${PLAYHOUSE_ROOT})
target_compile_features(playhouse_flags INTERFACE cxx_std_20)  # for projects that take this one in as a part
# Results must not depend on the optimiser: no fused multiply-add, no fast-math. Our headers compute as well.
target_compile_options(playhouse_flags INTERFACE -ffp-contract=off)
if(PLAYHOUSE_SANITIZE)
  target_compile_options(playhouse_flags INTERFACE -fsanitize=${PLAYHOUSE_SANITIZE} -fno-omit-frame-pointer)
  target_link_options(playhouse_flags INTERFACE -fsanitize=${PLAYHOUSE_SANITIZE})
  if(PLAYHOUSE_SANITIZE MATCHES undefined)
    target_compile_options(playhouse_flags INTERFACE -fno-sanitize-recover=undefined)
  endif()
endif()
if(PLAYHOUSE_FUZZ)
  add_compile_options(-fsanitize=fuzzer-no-link)
  add_custom_target(fuzzers)
endif()
add_custom_target(computed_tests)  # of COMPUTED modules: those that the release build runs as well

# LeakSanitizer follows a wild pointer where it mistakes a thread's own storage of Mesa's libraries for a table of its
# kind ("Tracer caught signal 11"); without the interceptor it does not look for one.
set(PLAYHOUSE_TEST_SANITIZERS ASAN_OPTIONS=set:intercept_tls_get_addr=0)

# How files of tests are compiled, beside the options of all: optimised they take the compiler twice as long, and what is
# tested are the libraries.
function(playhouse_test_options TARGET)
  target_compile_options(${TARGET} PRIVATE -O0)
  if(PLAYHOUSE_FUZZ)  # what fuzzers cover is the libraries
    target_compile_options(${TARGET} PRIVATE -fno-sanitize=fuzzer-no-link)
  endif()
endfunction()

# Options of modules with vector functions (simd/vectors.h): without the first two, which change no result, square roots
# and choices are not turned into vector instructions.
function(playhouse_vector_options TARGET)
  target_compile_options(${TARGET} PRIVATE -fno-math-errno -fno-trapping-math
    $<$<CXX_COMPILER_ID:Clang>:-Wno-bitwise-instead-of-logical>)
  if(PLAYHOUSE_SANITIZE)
    target_compile_options(${TARGET} PRIVATE -O1)
  endif()
endfunction()

# playhouse_gtest(TARGET NAME SHARDS n COMPUTED UNSANITIZED Suite.test...): the tests of a program, named NAME.1 to NAME.n:
# n runs of the program share them. A run of its own for each test would start a sanitized program two thousand times. Laws draw the same cases in every
# run, so that a red one can be repeated: a hundred; with sanitizers a tenth of those that the release draws as well. Of
# a COMPUTED program, tests that are UNSANITIZED run in the release alone: they take minutes with sanitizers and run nothing
# that others don't.
function(playhouse_gtest TARGET NAME)
  cmake_parse_arguments(ARG "COMPUTED" "SHARDS" "UNSANITIZED" ${ARGN})
  if(NOT ARG_SHARDS)
    set(ARG_SHARDS 1)
  endif()
  set(LAWS "seed=1")
  if(ARG_COMPUTED AND PLAYHOUSE_SANITIZE)
    set(LAWS "seed=1 max_success=10")
  endif()
  set(FILTER)
  if(ARG_UNSANITIZED AND PLAYHOUSE_SANITIZE)
    list(JOIN ARG_UNSANITIZED : FILTER)
    set(FILTER --gtest_filter=-${FILTER})
  endif()
  foreach(SHARD RANGE 1 ${ARG_SHARDS})
    math(EXPR INDEX "${SHARD} - 1")
    add_test(NAME ${NAME}.${SHARD} COMMAND ${TARGET} --gtest_brief=1 ${FILTER})
    set_tests_properties(${NAME}.${SHARD} PROPERTIES TIMEOUT 1500 LABELS "$<IF:$<BOOL:${ARG_COMPUTED}>,computed,unit>"
      ENVIRONMENT "RC_PARAMS=${LAWS};GTEST_TOTAL_SHARDS=${ARG_SHARDS};GTEST_SHARD_INDEX=${INDEX}"
      ENVIRONMENT_MODIFICATION "${PLAYHOUSE_TEST_SANITIZERS}")
  endforeach()
endfunction()

include(${CMAKE_CURRENT_LIST_DIR}/Precompiled.cmake)
include(${CMAKE_CURRENT_LIST_DIR}/Unity.cmake)

# playhouse_fuzzer(TARGET): a libFuzzer program, which asks of each input what it costs as well (base/fuzz_cost.cc).
function(playhouse_fuzzer TARGET)
  target_link_libraries(${TARGET} PRIVATE $<TARGET_OBJECTS:playhouse_fuzz_cost> -fsanitize=fuzzer)
  target_link_options(${TARGET} PRIVATE LINKER:--wrap=LLVMFuzzerTestOneInput)
  add_dependencies(fuzzers ${TARGET})
endfunction()

# playhouse_module(NAME DEPS a b c COMPUTED UNSANITIZED Suite.test HOT VECTORS PRECOMPILED world EXCEPT x.cc TOGETHER 8 APART y.cc ALONE z.cc)
# Declares the library playhouse_NAME from the folder's *.cc (and generated/*.cc, and two levels of folders below it).
# Beside a foo.cc: foo_test.cc goes into the test program, foo_bench.cc into the bench program and
# each foo_fuzz.cc becomes a libFuzzer program of its own. main.cc and what EXCEPT names are left to the caller.
# COMPUTED, SHARDS n, UNSANITIZED: see playhouse_gtest; UNSANITIZED * are all its tests. HOT: optimised with sanitizers,
# too, since tests spend their time there. VECTORS: HOT, with the options of playhouse_vector_options(). PRECOMPILED
# (library if left out): see Precompiled.cmake. TESTS_LEFT_OUT: files of tests of what EXCEPT leaves out. TOGETHER, APART, ALONE: see Unity.cmake.
function(playhouse_module NAME)
  cmake_parse_arguments(ARG "HOT;VECTORS;COMPUTED" "PRECOMPILED;SHARDS;TOGETHER" "DEPS;UNSANITIZED;EXCEPT;TESTS_LEFT_OUT;APART;ALONE" ${ARGN})
  if(NOT ARG_PRECOMPILED)
    set(ARG_PRECOMPILED library)
  endif()
  if(ARG_VECTORS)
    set(ARG_PRECOMPILED world)
  endif()
  file(GLOB SOURCES CONFIGURE_DEPENDS *.cc */*.cc */*/*.cc)
  list(FILTER SOURCES EXCLUDE REGEX "/testing/libraries/")  # of playhouse_test_libraries()
  set(TESTS ${SOURCES})
  set(BENCHES ${SOURCES})
  set(FUZZERS ${SOURCES})
  list(FILTER SOURCES EXCLUDE REGEX "(_test|_bench|_fuzz|/main)\\.cc$")
  foreach(FILE ${ARG_EXCEPT})
    list(REMOVE_ITEM SOURCES ${CMAKE_CURRENT_SOURCE_DIR}/${FILE})
  endforeach()
  list(FILTER TESTS INCLUDE REGEX "_test\\.cc$")
  list(FILTER BENCHES INCLUDE REGEX "_bench\\.cc$")
  list(FILTER FUZZERS INCLUDE REGEX "_fuzz\\.cc$")

  foreach(FILE ${ARG_TESTS_LEFT_OUT})
    list(REMOVE_ITEM TESTS ${CMAKE_CURRENT_SOURCE_DIR}/${FILE})
  endforeach()
  if(PLAYHOUSE_CORE AND PLAYHOUSE_TESTS)
    if(NOT NAME STREQUAL net)  # which needs the machine's own system calls; tests/e2e/test_core.py has sockets
      playhouse_core_tests(${TESTS})
    endif()
    set(TESTS)
  endif()

  set(TARGET playhouse_${NAME})
  if(SOURCES)
    add_library(${TARGET} STATIC ${SOURCES})
    if(ARG_VECTORS)
      playhouse_vector_options(${TARGET})
      playhouse_precompile(${TARGET} vectors)
    elseif(PLAYHOUSE_SANITIZE AND ARG_HOT)
      target_compile_options(${TARGET} PRIVATE -O1)
      playhouse_precompile(${TARGET} ${ARG_PRECOMPILED} OWN)
    else()
      playhouse_precompile(${TARGET} ${ARG_PRECOMPILED})
    endif()
    playhouse_unity(${TARGET} TOGETHER ${ARG_TOGETHER} APART ${ARG_APART} ALONE ${ARG_ALONE})
    set(SCOPE PUBLIC)
  else()
    add_library(${TARGET} INTERFACE)
    set(SCOPE INTERFACE)
  endif()
  target_link_libraries(${TARGET} ${SCOPE} $<BUILD_INTERFACE:playhouse_flags> ${ARG_DEPS})

  if(PLAYHOUSE_TESTS AND TESTS AND NOT (PLAYHOUSE_SANITIZE AND "${ARG_UNSANITIZED}" STREQUAL "*"))
    add_executable(${TARGET}_test ${TESTS})
    target_link_libraries(${TARGET}_test PRIVATE ${TARGET} rapidcheck rapidcheck_gtest GTest::gtest GTest::gmock GTest::gtest_main)
    target_compile_definitions(${TARGET}_test PRIVATE PLAYHOUSE_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
    playhouse_test_options(${TARGET}_test)
    playhouse_precompile(${TARGET}_test ${ARG_PRECOMPILED}_test)
    set(COMPUTED)
    if(ARG_COMPUTED)
      set(COMPUTED COMPUTED)
      add_dependencies(computed_tests ${TARGET}_test)
    endif()
    playhouse_gtest(${TARGET}_test ${NAME} SHARDS ${ARG_SHARDS} ${COMPUTED} UNSANITIZED ${ARG_UNSANITIZED})
  endif()
  if(PLAYHOUSE_BENCHES AND BENCHES)
    add_executable(${TARGET}_bench ${BENCHES})
    target_link_libraries(${TARGET}_bench PRIVATE ${TARGET} benchmark::benchmark_main)
    target_compile_definitions(${TARGET}_bench PRIVATE PLAYHOUSE_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
  endif()
  if(PLAYHOUSE_FUZZ)
    foreach(FUZZER ${FUZZERS})
      get_filename_component(PROGRAM ${FUZZER} NAME_WE)
      add_executable(${PROGRAM} ${FUZZER})
      target_link_libraries(${PROGRAM} PRIVATE ${TARGET})
      playhouse_fuzzer(${PROGRAM})
    endforeach()
  endif()
endfunction()

# playhouse_core_tests(FILES...): adds those files of tests to the program of tests of the device server that need nothing else:
# rapidcheck is there for this machine alone, and the small program has no simulator, pages, plug-ins and JSON.
function(playhouse_core_tests)
  foreach(FILE ${ARGN})
    file(STRINGS ${FILE} OTHERS REGEX "to_json|wire/json[.]h|#include.*(rapidcheck|playhouse/(bridge|images|run|scene|world)/|/(isolated|plugin|tls)/|websocket|http|simulated_page|drivers/testing/|testing_tiles|testing_hardware)")
    if(NOT OTHERS)
      set_property(GLOBAL APPEND PROPERTY PLAYHOUSE_CORE_TESTS ${FILE})
    endif()
  endforeach()
endfunction()

# playhouse_test_libraries(MODULE NAMES...)
# Shared libraries for the tests of a module: NAME.so of its testing/libraries/NAME.cc, in the folder TEST_LIBRARIES.
function(playhouse_test_libraries MODULE)
  foreach(NAME ${ARGN})
    set(TARGET test_${MODULE}_${NAME})
    add_library(${TARGET} MODULE testing/libraries/${NAME}.cc)
    target_link_libraries(${TARGET} PRIVATE playhouse_flags)
    set_target_properties(${TARGET} PROPERTIES PREFIX "" OUTPUT_NAME ${NAME}
      LIBRARY_OUTPUT_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR}/libraries)
    add_dependencies(playhouse_${MODULE}_test ${TARGET})
  endforeach()
  target_compile_definitions(playhouse_${MODULE}_test PRIVATE
    TEST_LIBRARIES="${CMAKE_CURRENT_BINARY_DIR}/libraries")
endfunction()
