#include "playhouse/record/rerun.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>

#include "playhouse/base/formats.h"
#include "playhouse/base/in_quotes.h"
#include "playhouse/record/cdr.h"
#include "playhouse/record/device_recording.h"
#include "playhouse/record/messages.h"
#include "playhouse/record/recorder.h"
#include "playhouse/world/changes/packed_change.h"
#include "playhouse/world/saving/whole_state.h"

namespace playhouse::record {
namespace {

/// Stores a message that matters for replay, and takes what it keeps from `left` [B]. Fails if it is
/// truncated, or nothing is left.
Result<void> take(const std::string& schema, std::span<const std::byte> body, Recording& into,
                  std::size_t& left) {
  CdrReader in(body);
  std::size_t kept = sizeof(Recording::ChangeOrCheck);
  if (schema == kState) {
    Recording::State state;
    state.tick = in.number<std::uint64_t>();
    state.bytes = PackedBytes(in.bytes());
    kept = sizeof state + state.bytes.packed_size();
    state.items = into.items.size();
    if (in.ok()) into.states.push_back(std::move(state));
  } else if (schema == kChange) {
    Recording::ChangeOrCheck item;
    item.tick = in.number<std::uint64_t>();
    for (int text = 0; text < 3; ++text) in.text();  // for people
    item.change = PackedBytes(in.bytes());
    kept += item.change.packed_size();
    if (in.ok() && item.change.empty()) return Error{{}, "a change in it is damaged"};
    if (in.ok()) into.items.push_back(std::move(item));
  } else if (schema == kCheck) {
    Recording::ChangeOrCheck item;
    item.tick = in.number<std::uint64_t>();
    item.hash = in.number<std::uint64_t>();
    item.sensed_hash = in.number<std::uint64_t>();
    if (in.ok()) into.items.push_back(std::move(item));
  } else {
    return {};
  }
  if (kept > left) return Error{{}, "has too much to run again: states and changes beyond what is kept"};
  left -= kept;
  return in.ok() ? Result<void>() : Error{{}, "a message in it is damaged"};
}

Error other_format(std::string_view format) {
  return {{},
          fmt::format("is a recording of format {}; this program reads format {}", in_quotes(format),
                      formats::kRecording)};
}

}  // namespace

Result<Recording> read_recording(const ByteSource& source, std::size_t most) {
  Recording recording;
  std::size_t left = most;
  bool has_format = false, has_start = false, has_message = false;
  McapReader reader(source);
  const auto end = reader.read(
      {.message = [&](const Channel& channel, const MessageRecord& message) -> Result<void> {
         has_message = true;
         const auto schema = reader.schemas().find(channel.schema);
         if (schema == reader.schemas().end() || !schema->second.name.starts_with("playhouse/msg/"))
           return {};
         return take(schema->second.name, message.body, recording, left);
       },
       .attachment = [&](const Attachment& attachment) -> Result<void> {
         if (attachment.name.starts_with(kFormatName)) {
           const std::string format = attachment.name.substr(kFormatName.size());
           if (format != std::to_string(formats::kRecording)) return other_format(format);
           has_format = true;
         }
         if (attachment.name != kStartName) return {};
         if (!has_format) return other_format("1");  // had no number
         Result<world::SavedRun> run = world::decode_saved_run(attachment.body);
         if (!run) return Error{{}, "its start " + run.error().text};
         recording.start = std::move(*run);
         has_start = true;
         return {};
       }});
  if (!end) return end.error();
  recording.cut = *end == McapReader::FileEnd::kCut;
  if (recording.cut && !has_message)
    return Error{{}, "was not finished and ends before its first whole chunk: there is nothing to run again"};
  if (!has_start && is_of_devices(reader)) return only_of_devices("no run to run again");
  if (!has_start)
    return Error{{},
                 "is not a recording of Playhouse: the attachment " + in_quotes(kStartName) + " is missing"};
  if (recording.states.empty())
    return Error{{}, "has data alone: its states could not be saved, so it cannot be run again"};
  return recording;
}

Rerun::Rerun(const Recording& recording, std::unique_ptr<world::Engine> engine)
    : recording_(&recording), engine_(std::move(engine)) {}

Result<void> Rerun::load(const Recording::State& state) {
  const Result<void> loaded = world::load_whole(world(), state.bytes.unpacked());
  if (!loaded) return Error{{}, "the recorded state " + loaded.error().text};
  next_ = state.items;
  return {};
}

Result<void> Rerun::begin() {
  return load(recording_->states.front());
}

std::uint64_t Rerun::last_tick() const {
  const std::uint64_t last =
      recording_->items.empty() ? recording_->states.back().tick : recording_->items.back().tick;
  return std::max(last, first_tick());
}

void Rerun::fail(const std::string& what) {
  if (!differs_) differs_ = fmt::format("at {} s, tick {}: {}", world().time(), world().tick(), what);
}

/// A partially loaded world is unusable, but may
/// be displayed: falls back to the initial state.
void Rerun::fail_to_load(const std::string& what) {
  fail(what);
  static_cast<void>(load(recording_->states.front()));
}

void Rerun::check(const Recording::ChangeOrCheck& item) {
  if (differs_) return;
  if (world().hash() != item.hash)
    fail(
        fmt::format("robots did something else (hash {:016x}, recorded {:016x})", world().hash(), item.hash));
  else if (world().sensed_hash() != item.sensed_hash)
    fail(fmt::format("sensors measured something else (hash {:016x}, recorded {:016x})",
                     world().sensed_hash(), item.sensed_hash));
  else
    ++checks_;
}

void Rerun::change(const Recording::ChangeOrCheck& item) {
  const Bytes bytes = item.change.unpacked();
  Unpacker in(bytes);
  const Result<world::Change> change = world::unpack_change(in);
  if (!change) return fail("the recording " + change.error().text);
  if (world::apply(world(), *change)) return;
  const std::string what =
      fmt::format("the change \"{}\" of the recording cannot be made", world::name_of(*change));
  std::holds_alternative<world::changes::Load>(*change) ? fail_to_load(what) : fail(what);
}

/// Applies the changes of this tick, including rewinds that happened at it.
void Rerun::happen() {
  while (!differs_ && !at_end() && recording_->items[next_].tick == world().tick()) {
    const Recording::ChangeOrCheck& item = recording_->items[next_++];
    item.change.empty() ? check(item) : change(item);
  }
  if (!differs_ && !at_end() && recording_->items[next_].tick < world().tick())
    fail("the recording has something of an earlier tick here");
}

void Rerun::step() {
  happen();
  if (at_end() || differs_) return;
  engine_->step();
}

void Rerun::seek(std::uint64_t tick) {
  const std::vector<Recording::State>& states = recording_->states;
  // The last match: after a rewind there may be two for one tick.
  const auto is_before = [&](const Recording::State& state) { return state.tick <= tick; };
  const auto last = std::find_if(states.rbegin(), states.rend(), is_before);
  const Recording::State& from = last == states.rend() ? states.front() : *last;
  differs_.reset();
  if (const Result<void> loaded = load(from); !loaded) return fail_to_load(loaded.error().line());
  while (world().tick() < tick && !at_end() && !differs_) step();
}

}  // namespace playhouse::record
