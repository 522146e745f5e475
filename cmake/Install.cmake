# cmake --install: the program with its worlds, examples, clients in Python and documentation (docs/install.md), and
# find_package(playhouse) for libraries that it loads (docs/libraries.md) and for programs that are its clients
# (docs/clients.md).

include(cmake/InstallClient.cmake)

install(TARGETS playhouse RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
install(FILES ${PLAYHOUSE_PROGRAM_DIR}/player DESTINATION ${CMAKE_INSTALL_BINDIR})  # a link to it

# Folders as in the source tree, so that the documents, and programs that name others, hold for both. The program looks
# for its worlds there (playhouse/config/CMakeLists.txt).
set(DATA_DIR ${CMAKE_INSTALL_DATADIR}/playhouse)
install(DIRECTORY worlds examples DESTINATION ${DATA_DIR}
  REGEX "/examples/(controller/)?CMakeLists.txt$" EXCLUDE  # of this build
  REGEX "/(build|__pycache__)$" EXCLUDE)
install(DIRECTORY clients/python DESTINATION ${DATA_DIR}/clients REGEX "/(tests|__pycache__)$" EXCLUDE)
install(DIRECTORY docs DESTINATION ${CMAKE_INSTALL_DOCDIR} REGEX "/adr$" EXCLUDE)
install(FILES README.md CHANGELOG.md LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})

# What custom models, controllers and drivers include; tests/e2e/test_libraries.py and test_plugins.py build with
# nothing else.
foreach(MODULE base config geom scene world)
  install(DIRECTORY playhouse/${MODULE} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/playhouse FILES_MATCHING PATTERN "*.h"
    PATTERN "testing*" EXCLUDE PATTERN "fuzz_script.h" EXCLUDE)
endforeach()
install(FILES playhouse/mesh/placement.h DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/playhouse/mesh)  # of scene_desc.h
install(FILES playhouse/controllers/controller.h DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/playhouse/controllers)
install(FILES playhouse/drivers/plugin/plugin.h DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/playhouse/drivers/plugin)

set(PACKAGE_DIR ${DATA_DIR}/cmake)
configure_package_config_file(cmake/playhouse-config.cmake.in ${CMAKE_BINARY_DIR}/playhouse-config.cmake
  INSTALL_DESTINATION ${PACKAGE_DIR} PATH_VARS CMAKE_INSTALL_INCLUDEDIR CLIENT_PACKAGE_DIR
  NO_CHECK_REQUIRED_COMPONENTS_MACRO)
write_basic_package_version_file(${CMAKE_BINARY_DIR}/playhouse-config-version.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_BINARY_DIR}/playhouse-config.cmake ${CMAKE_BINARY_DIR}/playhouse-config-version.cmake
  DESTINATION ${PACKAGE_DIR})
