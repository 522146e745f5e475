// A controller of a version that never was.
#include <cstdint>

extern "C" std::uint32_t playhouse_controller_version() {
  return 999;
}
extern "C" void* playhouse_controller_make() {
  return nullptr;
}
