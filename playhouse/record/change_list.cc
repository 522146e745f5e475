#include "playhouse/record/change_list.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "playhouse/base/in_quotes.h"
#include "playhouse/record/cdr.h"
#include "playhouse/record/device_recording.h"
#include "playhouse/record/messages.h"

namespace playhouse::record {
namespace {

constexpr std::string_view kHeader = "time,tick,change,model,fields\n";

/// A field as in RFC 4180, without control characters: it is shown in terminals.
std::string field(const std::string& text) {
  const std::string shown = escaped(text);
  if (shown.find_first_of(",\"") == std::string::npos) return shown;
  std::string quoted = "\"";
  for (const char letter : shown) quoted.append(letter == '"' ? 2 : 1, letter);
  return quoted + '"';
}

}  // namespace

Result<ChangeCount> list_changes(const ByteSource& source,
                                 const std::function<void(std::string_view)>& write) {
  ChangeCount count;
  McapReader reader(source);
  const auto end = reader.read(
      {.message = [&](const Channel& channel, const MessageRecord& message) -> Result<void> {
         const auto schema = reader.schemas().find(channel.schema);
         if (schema == reader.schemas().end() || schema->second.name != kChange) return {};
         CdrReader in(message.body);
         const auto tick = in.number<std::uint64_t>();
         const std::string name = in.text(), model = in.text(), fields = in.text();
         if (!in.ok()) return Error{{}, "a change in it is damaged"};
         if (count.changes++ == 0) write(kHeader);
         const double time = static_cast<double>(message.publish_time) * 1e-9;
         write(fmt::format("{:g},{},{},{},{}\n", time, tick, field(name), field(model), field(fields)));
         return {};
       },
       .attachment = {}});
  if (!end) return end.error();
  const auto is_kept = [&](const auto& channel) {
    const auto schema = reader.schemas().find(channel.second.schema);
    return schema != reader.schemas().end() && schema->second.name == kChange;
  };
  const bool has_list = std::ranges::any_of(reader.channels(), is_kept);
  if (!has_list && is_of_devices(reader)) return only_of_devices("no changes");
  if (!has_list) return Error{{}, "has no list of changes: it was not recorded by this version of Playhouse"};
  if (count.changes == 0) write(kHeader);
  count.cut = *end == McapReader::FileEnd::kCut;
  return count;
}

}  // namespace playhouse::record
