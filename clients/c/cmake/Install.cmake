# cmake --install: find_package(playhouse_c), playhouse::c, and pkg-config playhouse_c; pkg-config playerc and playerc++.

include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

# playhouse_c_shared(NAME OF LIBRARIES...): the shared library of the objects of a static one. Its interface may change
# with a minor version, as that of CMake's package.
function(playhouse_c_shared NAME OF)
  add_library(${OF}_shared SHARED $<TARGET_OBJECTS:${OF}>)
  set_target_properties(${OF}_shared PROPERTIES OUTPUT_NAME ${NAME} LINKER_LANGUAGE C INSTALL_RPATH $ORIGIN
    VERSION ${PROJECT_VERSION} SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
  target_link_libraries(${OF}_shared PRIVATE ${ARGN})
  target_link_options(${OF}_shared PRIVATE LINKER:--no-undefined)
  install(TARGETS ${OF}_shared)
endfunction()
playhouse_c_shared(playhouse_c playhouse_c ZLIB::ZLIB m)
playhouse_c_shared(playerc playhouse_playerc playhouse_c_shared ${PLAYERC_JPEG} m)

install(TARGETS playhouse_c EXPORT playhouse_c)
install(TARGETS playhouse_playerc)
install(DIRECTORY include/ generated/include/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(DIRECTORY playerc/include/ playerc/generated/include/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/player-3.1)

set(PACKAGE_DIR ${CMAKE_INSTALL_LIBDIR}/cmake/playhouse_c)
install(EXPORT playhouse_c NAMESPACE playhouse:: DESTINATION ${PACKAGE_DIR} FILE playhouse_c-targets.cmake)
write_basic_package_version_file(${CMAKE_CURRENT_BINARY_DIR}/playhouse_c-config-version.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES cmake/playhouse_c-config.cmake ${CMAKE_CURRENT_BINARY_DIR}/playhouse_c-config-version.cmake
  DESTINATION ${PACKAGE_DIR})

file(RELATIVE_PATH UP "/${CMAKE_INSTALL_LIBDIR}/pkgconfig" "/")  # from the file to the prefix
foreach(PACKAGE playhouse_c playerc playerc++)
  configure_file(cmake/${PACKAGE}.pc.in ${PACKAGE}.pc @ONLY)
  install(FILES ${CMAKE_CURRENT_BINARY_DIR}/${PACKAGE}.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
endforeach()
