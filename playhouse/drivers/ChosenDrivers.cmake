# Of DRIVERS, DRIVERS_WITH_MAPS and PLAYHOUSE_DRIVERS: CHOSEN_DRIVERS, a source with the list of those that were chosen (registry.h), and
# LEFT_OUT, the sources of the others, with their tests in TESTS_LEFT_OUT. vfh:Vfh is a folder; of a family, as scans/lasercutter:LaserCutter,
# the files scans/lasercutter.cc and lasercutter_test.cc are the driver's, and the others of scans/ are for all of it.

if(NOT PLAYHOUSE_CORE AND NOT PLAYHOUSE_DRIVERS STREQUAL all)
  message(FATAL_ERROR "invalid PLAYHOUSE_DRIVERS: the whole program has all drivers; PLAYHOUSE_CORE may have fewer")
endif()
set(KNOWN)
list(JOIN DRIVERS_WITH_MAPS | MAP_DRIVERS)
if(PLAYHOUSE_CORE AND NOT ZLIB_FOUND)
  list(JOIN DRIVERS_WITH_MAPS " and " NAMES)
  message(STATUS "without zlib for this machine there is no ${NAMES}")
  set(WITHOUT ${DRIVERS_WITH_MAPS})
endif()
set(CHOSEN)
set(LEFT_OUT)
set(DEFINITIONS)
set(FAMILIES)
set(CHOSEN_FAMILIES)
foreach(DRIVER ${DRIVERS})
  string(REPLACE ":" ";" PARTS ${DRIVER})
  list(GET PARTS 0 PLACE)
  list(GET PARTS 1 DEFINITION)
  get_filename_component(NAME ${PLACE} NAME)
  get_filename_component(FAMILY ${PLACE} DIRECTORY)
  list(APPEND KNOWN ${NAME})
  list(APPEND FAMILIES ${FAMILY})
  if((PLAYHOUSE_DRIVERS STREQUAL all OR NAME IN_LIST PLAYHOUSE_DRIVERS) AND NOT NAME IN_LIST WITHOUT)
    list(APPEND CHOSEN ${NAME})
    list(APPEND CHOSEN_FAMILIES ${FAMILY})
    list(APPEND DEFINITIONS ${NAME}:${DEFINITION})
    if(NAME IN_LIST EMULATED AND NOT PLAYHOUSE_CORE)  # the device server alone is for the robot itself
      list(APPEND DEFINITIONS ${NAME}_emulator:${DEFINITION}Emulator)
    endif()
  elseif(FAMILY)
    file(GLOB SOURCES RELATIVE ${CMAKE_CURRENT_SOURCE_DIR} ${PLACE}.cc ${PLACE}_test.cc)
    list(APPEND LEFT_OUT ${SOURCES})
  else()
    file(GLOB SOURCES RELATIVE ${CMAKE_CURRENT_SOURCE_DIR} ${NAME}/*.cc)
    list(APPEND LEFT_OUT ${SOURCES})
  endif()
endforeach()
list(REMOVE_DUPLICATES FAMILIES)
foreach(FAMILY ${FAMILIES})
  if(NOT FAMILY IN_LIST CHOSEN_FAMILIES)
    file(GLOB SOURCES RELATIVE ${CMAKE_CURRENT_SOURCE_DIR} ${FAMILY}/*.cc)
    list(APPEND LEFT_OUT ${SOURCES})
  endif()
endforeach()
list(SORT DEFINITIONS)
set(DECLARED)
set(LISTED)
foreach(DEFINITION ${DEFINITIONS})
  string(REGEX REPLACE ".*:" "" DEFINITION ${DEFINITION})
  string(APPEND DECLARED "extern const DriverDefinition k${DEFINITION}Driver;\n")
  string(APPEND LISTED "    &k${DEFINITION}Driver,\n")
endforeach()
foreach(NAME ${PLAYHOUSE_DRIVERS})
  if(NOT PLAYHOUSE_DRIVERS STREQUAL all AND NOT NAME IN_LIST KNOWN)
    list(JOIN KNOWN ", " NAMES)
    message(FATAL_ERROR "invalid PLAYHOUSE_DRIVERS: there is no driver ${NAME}; there are ${NAMES}")
  endif()
endforeach()
if(NOT CHOSEN)
  message(FATAL_ERROR "invalid PLAYHOUSE_DRIVERS: a program needs a driver")
endif()
set(WITH_MAPS ${CHOSEN})
list(FILTER WITH_MAPS INCLUDE REGEX "^(${MAP_DRIVERS})$")
if(NOT WITH_MAPS)
  list(APPEND LEFT_OUT grid_map/distances.cc grid_map/distances_test.cc grid_map/map_reader.cc grid_map/grid_map_test.cc)
endif()
list(REMOVE_DUPLICATES LEFT_OUT)
set(TESTS_LEFT_OUT ${LEFT_OUT})
list(FILTER TESTS_LEFT_OUT INCLUDE REGEX "_test[.]cc$")
list(FILTER LEFT_OUT EXCLUDE REGEX "_(test|fuzz)[.]cc$")

set(CHOSEN_DRIVERS ${CMAKE_CURRENT_BINARY_DIR}/chosen_drivers.cc)
file(CONFIGURE OUTPUT ${CHOSEN_DRIVERS} @ONLY CONTENT [[#include "playhouse/drivers/registry.h"

namespace playhouse::drivers {

@DECLARED@
std::span<const DriverDefinition* const> core_drivers() {
  static constexpr const DriverDefinition* kChosen[] = {
@LISTED@  };
  return kChosen;
}

}  // namespace playhouse::drivers
]])
