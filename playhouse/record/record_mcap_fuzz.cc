// Any bytes are an MCAP file, a recording, a schema with a message, or are refused with a line.

#include <algorithm>
#include <cstdint>
#include <string>

#include "playhouse/base/assert.h"
#include "playhouse/record/mcap/mcap_reader.h"
#include "playhouse/record/message_type.h"
#include "playhouse/record/rerun.h"
#include "playhouse/record/testing/memory_source.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace playhouse;
  const auto bytes = std::as_bytes(std::span(data, size));
  const record::MemorySource source(bytes);
  record::McapReader reader(source);
  const auto end = reader.read(
      {.message = [](const record::Channel&, const record::MessageRecord&) -> Result<void> { return {}; },
       .attachment = [](const record::Attachment&) -> Result<void> { return {}; }});
  PLAYHOUSE_ASSERT(end.ok() || !end.error().text.empty());
  const auto recording = record::read_recording(source);
  PLAYHOUSE_ASSERT(recording.ok() || !recording.error().text.empty());
  // A schema, and behind a NUL a message of it.
  const std::string text(reinterpret_cast<const char*>(data), size);
  const std::size_t end_of_schema = std::min(text.find('\0'), size);
  const auto type = record::MessageSchema::parse(text.substr(0, end_of_schema));
  PLAYHOUSE_ASSERT(type.ok() || !type.error().text.empty());
  if (type) {
    const auto rows = type->rows(bytes.subspan(end_of_schema));
    PLAYHOUSE_ASSERT(rows.ok() || !rows.error().text.empty());
  }
  return 0;
}
