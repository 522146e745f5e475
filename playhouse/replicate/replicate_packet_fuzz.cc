// Any bytes are a packet for a small world, or are refused.

#include <cstdint>

#include "playhouse/replicate/delta.h"
#include "playhouse/replicate/small_world.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  using namespace playhouse::replicate;
  static const SmallWorld small(3);
  static const auto layout = small.layout();
  Replica replica(layout);
  const auto applied = apply_packet(std::as_bytes(std::span(bytes, size)), replica);
  PLAYHOUSE_ASSERT(applied.ok() || !applied.error().text.empty());
  return 0;
}
