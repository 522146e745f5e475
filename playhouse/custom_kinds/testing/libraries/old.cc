// A custom model of a version that never was.
#include <cstdint>

extern "C" std::uint32_t playhouse_custom_version() {
  return 999;
}
extern "C" void* playhouse_custom_make() {
  return nullptr;
}
