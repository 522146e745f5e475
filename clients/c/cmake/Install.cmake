# cmake --install: find_package(playhouse_c), playhouse::c, and pkg-config playhouse_c.

include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

install(TARGETS playhouse_c EXPORT playhouse_c)
install(DIRECTORY include/ generated/include/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})

set(PACKAGE_DIR ${CMAKE_INSTALL_LIBDIR}/cmake/playhouse_c)
install(EXPORT playhouse_c NAMESPACE playhouse:: DESTINATION ${PACKAGE_DIR} FILE playhouse_c-targets.cmake)
write_basic_package_version_file(${CMAKE_CURRENT_BINARY_DIR}/playhouse_c-config-version.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES cmake/playhouse_c-config.cmake ${CMAKE_CURRENT_BINARY_DIR}/playhouse_c-config-version.cmake
  DESTINATION ${PACKAGE_DIR})

file(RELATIVE_PATH UP "/${CMAKE_INSTALL_LIBDIR}/pkgconfig" "/")  # from the file to the prefix
configure_file(cmake/playhouse_c.pc.in playhouse_c.pc @ONLY)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/playhouse_c.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
