# cmake --install: the program, and find_package(playhouse) for libraries that it loads (docs/libraries.md) and for
# programs that are its clients (docs/clients.md).

include(cmake/InstallClient.cmake)

install(TARGETS playhouse RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})

# What custom models and controllers include; tests/e2e/test_libraries.py builds with nothing else.
foreach(MODULE base geom scene world)
  install(DIRECTORY playhouse/${MODULE} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/playhouse FILES_MATCHING PATTERN "*.h"
    PATTERN "testing*" EXCLUDE PATTERN "fuzz_script.h" EXCLUDE)
endforeach()
install(FILES playhouse/controllers/controller.h DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/playhouse/controllers)

set(PACKAGE_DIR ${CMAKE_INSTALL_DATADIR}/playhouse/cmake)
configure_package_config_file(cmake/playhouse-config.cmake.in ${CMAKE_BINARY_DIR}/playhouse-config.cmake
  INSTALL_DESTINATION ${PACKAGE_DIR} PATH_VARS CMAKE_INSTALL_INCLUDEDIR CLIENT_PACKAGE_DIR
  NO_CHECK_REQUIRED_COMPONENTS_MACRO)
write_basic_package_version_file(${CMAKE_BINARY_DIR}/playhouse-config-version.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_BINARY_DIR}/playhouse-config.cmake ${CMAKE_BINARY_DIR}/playhouse-config-version.cmake
  DESTINATION ${PACKAGE_DIR})
