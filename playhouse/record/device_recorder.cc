#include "playhouse/record/device_recorder.h"

#include <fmt/format.h>

#include <boost/json/object.hpp>
#include <boost/json/parse.hpp>
#include <boost/json/serialize.hpp>
#include <cmath>
#include <span>

#include "playhouse/base/log.h"
#include "playhouse/record/device_recording.h"
#include "playhouse/record/mcap/mcap.h"
#include "playhouse/wire/messages.h"

namespace playhouse::record {
namespace {

std::uint64_t ns_of(double seconds) {
  return seconds > 0 ? static_cast<std::uint64_t>(std::llround(seconds * 1e9)) : 0;
}

/// JSON Schema of a value: the types of its members, and of a list's first element.
boost::json::object schema_of(const boost::json::value& value) {
  if (const auto* const object = value.if_object()) {
    boost::json::object members;
    for (const auto& member : *object) members[member.key()] = schema_of(member.value());
    return {{"type", "object"}, {"properties", std::move(members)}};
  }
  if (const auto* const list = value.if_array()) {
    boost::json::object schema{{"type", "array"}};
    if (!list->empty()) schema["items"] = schema_of(list->front());
    return schema;
  }
  if (value.is_string()) return {{"type", "string"}};
  if (value.is_bool()) return {{"type", "boolean"}};
  return {{"type", "number"}};
}

/// "/6665/laser/0/scan" for "laser.data.scan".
std::string topic_of(const device::Address& address, std::string_view message) {
  return fmt::format("/{}/{}/{}/{}", address.robot, message.substr(0, message.find('.')), address.index,
                     message.substr(message.rfind('.') + 1));
}

}  // namespace

DeviceRecorder::DeviceRecorder(RecordThread& file, device::Publisher& next, std::function<double()> clock,
                               std::size_t most_bytes)
    : file_(file), next_(next), clock_(std::move(clock)), most_bytes_(most_bytes), thread_([this] {
        run();
      }) {}

void DeviceRecorder::add(device::DeviceId device, device::Address address) {
  const std::lock_guard lock(mutex_);
  recorded_[device] = address;
}

void DeviceRecorder::finish() {
  {
    const std::lock_guard lock(mutex_);
    ending_ = true;
  }
  changed_.notify_all();
  if (thread_.joinable()) thread_.join();
}

DeviceRecorder::RecordingStatus DeviceRecorder::status() const {
  const std::lock_guard lock(mutex_);
  return status_;
}

void DeviceRecorder::publish(std::vector<device::Publication> batch) {
  const double now = clock_();
  bool is_first_loss = false;
  {
    const std::lock_guard lock(mutex_);
    for (const device::Publication& each : batch) {
      const auto found = recorded_.find(each.device);
      if (found == recorded_.end() || ending_) continue;
      if (waiting_bytes_ >= most_bytes_) {
        is_first_loss |= status_.dropped++ == 0;
        continue;
      }
      waiting_bytes_ += sizeof(Arrival) + each.body.size();
      waiting_.push_back({found->second, each.subtype, now, each.timestamp, each.body});
    }
  }
  changed_.notify_all();
  if (is_first_loss) log::warn("the disk is slower than the devices: data are missing in the recording");
  next_.publish(std::move(batch));
}

void DeviceRecorder::run() {
  for (bool last = false; !last;) {
    std::vector<Arrival> heard;
    {
      std::unique_lock lock(mutex_);
      changed_.wait(lock, [this] { return ending_ || !waiting_.empty(); });
      heard.swap(waiting_);
      waiting_bytes_ = 0;
      last = ending_;
    }
    Bytes out;
    for (const Arrival& each : heard) put_message(each, out);
    file_.hand_over(std::move(out));
  }
}

void DeviceRecorder::put_message(const Arrival& heard, Bytes& out) {
  const wire::MessageDef* const message =
      wire::find_message(heard.address.interf, wire::MessageType::kData, heard.subtype);
  if (message == nullptr) return;
  std::string json;
  message->to_json(heard.body, json);
  if (json == "null") return;
  RecordedChannel* const channel = channel_of(heard, std::string(message->name), json, out);
  if (channel == nullptr) return;
  put(out, MessageRecord{channel->id, channel->sequence++, ns_of(heard.time), ns_of(heard.timestamp),
                         std::as_bytes(std::span(json))});
  const std::lock_guard lock(mutex_);
  ++status_.messages;
  status_.bytes += json.size();
}

DeviceRecorder::RecordedChannel* DeviceRecorder::channel_of(const Arrival& heard, const std::string& message,
                                                            std::string_view json, Bytes& out) {
  const auto found = channels_.find({heard.address, heard.subtype});
  if (found != channels_.end()) return &found->second;
  if (channels_.size() >= limits::kRecordChannels) {
    if (!std::exchange(full_, true))
      log::warn("a recording has {} channels at most: {} and what comes later is left out",
                limits::kRecordChannels, topic_of(heard.address, message));
    return nullptr;
  }
  const auto [schema, is_new] =
      schemas_.try_emplace(message, static_cast<std::uint16_t>(schemas_.size() + 1));
  if (is_new)
    put(out, Schema{schema->second, message, kDeviceSchemaEncoding,
                    boost::json::serialize(schema_of(boost::json::parse(json)))});
  const auto id = static_cast<std::uint16_t>(channels_.size());
  put(out, Channel{id, schema->second, topic_of(heard.address, message), kDeviceMessageEncoding});
  return &channels_.emplace(std::pair(heard.address, heard.subtype), RecordedChannel{id}).first->second;
}

}  // namespace playhouse::record
