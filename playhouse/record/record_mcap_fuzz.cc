// Any bytes are an MCAP file, a recording, and a change of a state, or are refused with a line.

#include <cstdint>

#include "playhouse/base/assert.h"
#include "playhouse/record/mcap_reader.h"
#include "playhouse/record/rerun.h"
#include "playhouse/record/testing/memory_source.h"
#include "playhouse/record/whole_state.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace playhouse;
  const auto bytes = std::as_bytes(std::span(data, size));
  const record::MemorySource source(bytes);
  record::McapReader reader(source);
  const auto end = reader.read(
      {.message = [](const record::Channel&, const record::Message&) -> Result<void> { return {}; },
       .attachment = [](const record::Attachment&) -> Result<void> { return {}; }});
  PLAYHOUSE_ASSERT(end.ok() || !end.error().text.empty());
  const auto recording = record::read_recording(source);
  PLAYHOUSE_ASSERT(recording.ok() || !recording.error().text.empty());
  const auto changed = record::patched(bytes.first(size / 2), bytes.subspan(size / 2));
  PLAYHOUSE_ASSERT(changed.ok() || !changed.error().text.empty());
  return 0;
}
