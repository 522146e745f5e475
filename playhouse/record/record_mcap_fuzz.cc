// Any bytes are an MCAP file, or are refused with a line.

#include <cstdint>

#include "playhouse/base/assert.h"
#include "playhouse/record/mcap_reader.h"
#include "playhouse/record/testing/memory_source.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  using namespace playhouse;
  const record::MemorySource source(std::as_bytes(std::span(bytes, size)));
  record::McapReader reader(source);
  const auto end = reader.read({.message = [](const record::Channel&, const record::Message&) -> Result<void> { return {}; },
                                .attachment = [](const record::Attachment&) -> Result<void> { return {}; }});
  PLAYHOUSE_ASSERT(end.ok() || !end.error().text.empty());
  return 0;
}
