# Files that codegen makes of interfaces/, kinds/ and viewer/ (docs/adr/0026): before anything looks for them, and again by the
# build after a change of what they are made of, which configures anew first. Those whose content stays keep their time.

include_guard(GLOBAL)
get_filename_component(PLAYHOUSE_ROOT ${CMAKE_CURRENT_LIST_DIR}/.. ABSOLUTE)

find_package(Python3 3.11 COMPONENTS Interpreter)
if(NOT Python3_FOUND)
  if(NOT EXISTS ${PLAYHOUSE_ROOT}/playhouse/wire/generated/catalogue.cc)
    message(FATAL_ERROR "Python 3.11 or newer is needed: it writes what is generated from interfaces/ and kinds/")
  endif()
  message(WARNING "without Python 3.11 or newer, files that are generated are taken as they are")  # as in an archive of `make source`
  return()
endif()

file(GLOB PLAYHOUSE_DEFINITIONS CONFIGURE_DEPENDS ${PLAYHOUSE_ROOT}/interfaces/*.toml ${PLAYHOUSE_ROOT}/kinds/*.toml
  ${PLAYHOUSE_ROOT}/viewer/*.toml ${PLAYHOUSE_ROOT}/codegen/*.py ${PLAYHOUSE_ROOT}/codegen/*/*.py)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${PLAYHOUSE_DEFINITIONS})
execute_process(COMMAND ${Python3_EXECUTABLE} -m codegen WORKING_DIRECTORY ${PLAYHOUSE_ROOT}
  OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
