# cmake --install: find_package(playhouse_client), playhouse::client, of the C++ client library built alone
# (clients/cpp/CMakeLists.txt) and of the program (cmake/Install.cmake).

include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

foreach(LIBRARY client wire base)
  set_target_properties(playhouse_${LIBRARY} PROPERTIES EXPORT_NAME ${LIBRARY})
endforeach()
if(PLAYHOUSE_SANITIZE)  # what links objects with sanitizers needs them as well
  target_link_options(playhouse_base PUBLIC $<INSTALL_INTERFACE:-fsanitize=${PLAYHOUSE_SANITIZE}>)
endif()
install(TARGETS playhouse_client playhouse_wire playhouse_base EXPORT playhouse_client
  INCLUDES DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})

if(TARGET playhouse_client_shared)
  set_target_properties(playhouse_client_shared PROPERTIES EXPORT_NAME client_shared)
  install(TARGETS playhouse_client_shared EXPORT playhouse_client INCLUDES DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
endif()

install(DIRECTORY ${PLAYHOUSE_ROOT}/clients/cpp/include/playhouse_client ${PLAYHOUSE_ROOT}/clients/cpp/generated/playhouse_client DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(DIRECTORY ${PLAYHOUSE_ROOT}/playhouse/base ${PLAYHOUSE_ROOT}/playhouse/wire
  DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/playhouse FILES_MATCHING PATTERN "*.h"
  PATTERN "log*.h" EXCLUDE PATTERN "line_*.h" EXCLUDE PATTERN "version.h" EXCLUDE  # of the program
  PATTERN "testing*" EXCLUDE PATTERN "fuzz_*.h" EXCLUDE PATTERN "samples.h" EXCLUDE PATTERN "test_bytes.h" EXCLUDE)

set(CLIENT_PACKAGE_DIR ${CMAKE_INSTALL_LIBDIR}/cmake/playhouse_client)
install(EXPORT playhouse_client NAMESPACE playhouse:: DESTINATION ${CLIENT_PACKAGE_DIR}
  FILE playhouse_client-config.cmake)  # the targets need no other package
write_basic_package_version_file(${CMAKE_CURRENT_BINARY_DIR}/playhouse_client-config-version.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/playhouse_client-config-version.cmake DESTINATION ${CLIENT_PACKAGE_DIR})
