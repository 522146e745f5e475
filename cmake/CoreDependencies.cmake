# Libraries that the device server alone is made with: headers, which are the same for all machines, and zlib where the
# machine's is there. The headers get a folder of their own, for cross compilers that do not look where this machine's are.

set(CORE_HEADERS ${CMAKE_BINARY_DIR}/headers)
file(MAKE_DIRECTORY ${CORE_HEADERS})
foreach(NAME fmt spdlog asio asio.hpp)
  if(NOT EXISTS /usr/include/${NAME})
    message(FATAL_ERROR "${NAME} is needed: make core installs libfmt-dev, libspdlog-dev and libasio-dev")
  endif()
  file(CREATE_LINK /usr/include/${NAME} ${CORE_HEADERS}/${NAME} SYMBOLIC)
endforeach()
add_library(core_headers INTERFACE)
target_include_directories(core_headers SYSTEM INTERFACE ${CORE_HEADERS})
add_library(core_fmt INTERFACE)
target_compile_definitions(core_fmt INTERFACE FMT_HEADER_ONLY FMT_STATIC_THOUSANDS_SEPARATOR=',')
target_link_libraries(core_fmt INTERFACE core_headers)
add_library(fmt::fmt ALIAS core_fmt)
add_library(core_spdlog INTERFACE)
target_compile_definitions(core_spdlog INTERFACE SPDLOG_FMT_EXTERNAL)
target_link_libraries(core_spdlog INTERFACE core_fmt)
add_library(spdlog::spdlog ALIAS core_spdlog)

# Maps are sent compressed: without zlib there is no amcl and no wavefront.
set(ZLIB_USE_STATIC_LIBS ON)
find_package(ZLIB)
if(NOT ZLIB_FOUND)
  add_library(core_zlib INTERFACE)
  add_library(ZLIB::ZLIB ALIAS core_zlib)
endif()
if(PLAYHOUSE_TESTS AND NOT EXISTS /usr/src/googletest)
  set(PLAYHOUSE_TESTS OFF)  # as of who builds the program alone
endif()
if(PLAYHOUSE_TESTS)  # Debian's googletest comes as source as well
  set(INSTALL_GTEST OFF)
  add_subdirectory(/usr/src/googletest ${CMAKE_BINARY_DIR}/googletest EXCLUDE_FROM_ALL)
endif()

# 32-bit PowerPC has no instruction for 64 bits at once.
include(CheckCXXSourceCompiles)
check_cxx_source_compiles("#include <atomic>\n#include <cstdint>\nstd::atomic<std::uint64_t> n; int main() { return static_cast<int>(++n); }"
  CORE_HAS_ATOMICS)
if(NOT CORE_HAS_ATOMICS)
  target_link_libraries(core_headers INTERFACE atomic)
endif()

# What nothing calls is not in the program, which needs no library of the machine that it runs on.
add_compile_options(-Wno-psabi)  # notes of what g++ 10 changed on ARM
add_compile_options(-ffunction-sections -fdata-sections)
add_link_options(-static -Wl,--gc-sections -s)
