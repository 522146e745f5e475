// A custom model that is built with headers of a program with other columns.
#include "playhouse/world/custom_kind.h"

extern "C" std::uint32_t playhouse_custom_version() {
  return playhouse::world::kCustomVersion;
}
extern "C" std::uint64_t playhouse_custom_layout() {
  return 1;
}
extern "C" void* playhouse_custom_make() {
  return nullptr;
}
