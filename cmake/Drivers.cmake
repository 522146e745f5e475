# playhouse_driver_list(VARIABLE FUNCTION HEADER NAME:Definition...): a source that defines FUNCTION, which HEADER declares: the drivers of
# a module, each a kDefinitionDriver, in the order of their names. Its path is left in VARIABLE.
function(playhouse_driver_list VARIABLE FUNCTION HEADER)
  set(DEFINITIONS ${ARGN})
  list(SORT DEFINITIONS)
  list(LENGTH DEFINITIONS COUNT)
  set(DECLARED)
  set(LISTED)
  foreach(DEFINITION ${DEFINITIONS})
    string(REGEX REPLACE ".*:" "" DEFINITION ${DEFINITION})
    string(APPEND DECLARED "extern const DriverDefinition k${DEFINITION}Driver;\n")
    string(APPEND LISTED "    &k${DEFINITION}Driver,\n")
  endforeach()
  set(PATH ${CMAKE_CURRENT_BINARY_DIR}/${FUNCTION}.cc)
  file(CONFIGURE OUTPUT ${PATH} @ONLY CONTENT [[#include <array>

#include "@HEADER@"

namespace playhouse::drivers {

@DECLARED@
std::span<const DriverDefinition* const> @FUNCTION@() {
  static constexpr std::array<const DriverDefinition*, @COUNT@> kDrivers = {{
@LISTED@  }};
  return kDrivers;
}

}  // namespace playhouse::drivers
]])
  set(${VARIABLE} ${PATH} PARENT_SCOPE)
endfunction()
