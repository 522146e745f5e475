#include "playhouse/record/recorder.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <string_view>

#include "playhouse/base/formats.h"
#include "playhouse/base/limits.h"
#include "playhouse/base/log.h"
#include "playhouse/base/version.h"
#include "playhouse/record/sensor_messages.h"
#include "playhouse/replicate/views.h"
#include "playhouse/world/changes/packed_change.h"
#include "playhouse/world/periods.h"
#include "playhouse/world/saving/saved_run.h"
#include "playhouse/world/saving/state.h"
#include "playhouse/world/saving/whole_state.h"

namespace playhouse::record {
namespace {

constexpr const char* kWorldFrame = "world";
constexpr const char* kChangesTopic = "/playhouse/changes";

const char* word_of(world::Event::EventKind kind) {
  switch (kind) {
    case world::Event::EventKind::kSpawn:
      return "came";
    case world::Event::EventKind::kDespawn:
      return "went";
    case world::Event::EventKind::kAttach:
      return "attached";
    case world::Event::EventKind::kDetach:
      return "detached";
    case world::Event::EventKind::kPlace:
      return "placed";
    case world::Event::EventKind::kSet:
      return "set";
    case world::Event::EventKind::kReload:
      return "taken back";
  }
  return "";
}

Bytes bytes_of(std::string_view text) {
  const auto bytes = std::as_bytes(std::span(text));
  return {bytes.begin(), bytes.end()};
}

/// One level of a topic as ROS 2 accepts it: letters and digits, one _ for others between them, no digit
/// first.
std::string as_level(std::string_view name) {
  std::string level;
  for (const char letter : name) {
    if (std::isalnum(static_cast<unsigned char>(letter)) != 0)
      level += letter;
    else if (!level.empty() && level.back() != '_')
      level += '_';
  }
  if (level.ends_with('_')) level.pop_back();
  const bool is_plain = !level.empty() && std::isdigit(static_cast<unsigned char>(level.front())) == 0;
  return is_plain ? level : "m" + level;
}

/// Topic name: a level for each part of a name, which dots separate.
std::string as_topic(std::string_view name) {
  std::string topic;
  for (std::size_t begin = 0; begin <= name.size();) {
    const std::size_t end = std::min(name.find('.', begin), name.size());
    topic += (topic.empty() ? "" : "/") + as_level(name.substr(begin, end - begin));
    begin = end + 1;
  }
  return topic;
}

}  // namespace

Recorder::Recorder(RecordThread& file, Selection selection, world::Control& control)
    : file_(file), selection_(std::move(selection)), control_(control) {}

Result<void> Recorder::begin(const world::World& world, const config::SourceFiles& sources) {
  interval_ = world.scene().interval;
  second_ = world::ticks_of(1, interval_);
  state_ticks_ = world::ticks_of(kStatePeriod, interval_);
  steps_ = world.tick();
  for (const std::string& name : selection_.unknown_names(world))
    log::warn("--record-only: no model is called {} yet", name);
  world::SavedRun run{sources, world.engine, world.seed(), {}};
  if (const Result<void> saved = world::save_state(world, run.state); !saved) {
    give_up(saved.error());
    run.state.clear();
  }
  const Attachment format{ns(), std::string(kFormatName) + std::to_string(formats::kRecording), "text/plain",
                          bytes_of(build())};
  if (const Result<void> attached = file_.attach(format); !attached) return attached;
  const Attachment start{ns(), kStartName, "application/octet-stream", world::encode(run)};
  if (const Result<void> attached = file_.attach(start); !attached) return attached;
  look_around(world);
  // Reserved before other channels: replay is impossible without it.
  channel_of(kChangesTopic, kChange);
  tick_ = world.tick();
  record_state(world);
  record_poses(world, true);
  record_speech(world);
  record_check(world);
  hand_over();
  return {};
}

void Recorder::give_up(const Error& why) {
  if (!std::exchange(runs_again_, false)) return;
  log::warn("the recording has data alone, and cannot be run again or replayed: {}", why.line());
}

std::uint64_t Recorder::ns(std::uint64_t ago) const {
  return static_cast<std::uint64_t>(std::llround(static_cast<double>(steps_ - ago) * interval_ * 1e9));
}

std::optional<std::uint16_t> Recorder::channel_of(const std::string& topic, const std::string& schema) {
  const auto [kind, is_new_kind] = schemas_.try_emplace(schema, schemas_.size() + 1);
  if (is_new_kind) put(out_, Schema{kind->second, schema, kSchemaEncoding, schema_text(schema)});
  auto channel = channels_.find({topic, schema});
  if (channel == channels_.end()) {
    if (channels_.size() >= limits::kRecordChannels) {
      if (!std::exchange(full_, true))
        log::warn("a recording has {} channels at most: {} and what comes later is left out",
                  limits::kRecordChannels, topic);
      return std::nullopt;
    }
    const auto id = static_cast<std::uint16_t>(channels_.size());
    channel = channels_.emplace(std::pair(topic, schema), id).first;
    put(out_, Channel{id, kind->second, topic, kMessageEncoding});
    sequence_.push_back(0);
  }
  return channel->second;
}

void Recorder::put_message(const world::World& world, const std::string& topic, const std::string& schema,
                           const Bytes& body, std::uint64_t ago) {
  put_message_at(world.time_of(world.tick() - ago), topic, schema, body, ago);
}

void Recorder::put_message_at(double time, const std::string& topic, const std::string& schema,
                              const Bytes& body, std::uint64_t ago) {
  const std::optional<std::uint16_t> channel = channel_of(topic, schema);
  if (!channel) return;
  const auto published = static_cast<std::uint64_t>(std::llround(time * 1e9));
  put(out_, MessageRecord{*channel, sequence_[*channel]++, ns(ago), published, body});
}

void Recorder::hand_over() {
  file_.hand_over(std::exchange(out_, {}));
}

// --- population

/// Models whose names differ in characters that topics lack get a number each: one topic, and frame, for one
/// model.
std::string Recorder::label(const world::World& world, world::ModelRow model) {
  const auto name_of = [&world](world::ModelRow row) {
    std::string name = world.name(row);
    return name.empty() ? world.alias(row) : name;
  };
  const std::string name = name_of(model);
  std::string topic = as_topic(name);
  if (const world::ModelRow top = world.models.root[model]; top != model) {
    const std::string of_top = name_of(top) + ".";
    if (name.starts_with(of_top))
      topic = label(world, top) + "/" + as_topic(std::string_view(name).substr(of_top.size()));
  }
  const world::ModelId id = world.id(model);
  for (int number = 1;; ++number) {
    std::string label = number == 1 ? topic : topic + "_" + std::to_string(number);
    world::ModelId& owner = labels_.try_emplace(label, id).first->second;
    if (owner != id && world.row(owner)) continue;
    owner = id;
    return label;
  }
}

/// Also of a model that has gone since; empty for none.
std::string Recorder::label_of(const world::World& world, world::ModelId model) {
  if (const world::ModelRow row = world.row(model)) return label(world, row);
  const auto gone = std::ranges::find(labels_, model, [](const auto& each) { return each.second; });
  return model && gone != labels_.end() ? gone->first : std::string();
}

void Recorder::look_around(const world::World& world) {
  if (std::exchange(known_, true) && population_ == world.population()) return;
  population_ = world.population();
  recorded_.clear();
  frames_.clear();
  measuring_.clear();
  for (const world::ModelRow row : world.models.rows()) add_model(world, {row});
  const bool all_watched = std::ranges::all_of(measuring_, [&](world::ModelId model) {
    const auto found = watched_.find(model);
    return found != watched_.end() && found->second == control_.generation(model);
  });
  // Retries at the next tick if the queue is full.
  if (!all_watched && !control_.post([this](world::Journal& journal) { watch_all(journal); })) known_ = false;
}

void Recorder::add_model(const world::World& world, world::ModelRow model) {
  const world::Models& models = world.models;
  const scene::ModelKind kind = models.kind[model];
  const world::ModelId id = world.id(model);
  if (models.root[model] == model && models.mobility[model] != world::Mobility::kFixed)
    frames_.push_back({.model = id, .parent = {}, .kind = FrameKind::kModel, .sensor = 0, .last = {}});
  bool recorded = false;
  for (const TableMessages& table : table_messages()) {
    if (!table.has(world, model) || !selection_.has(world, model, table.topic)) continue;
    recorded = true;
    Recorded entry;
    entry.model = id;
    entry.table = &table;
    entry.topic = "/" + label(world, model) + "/" + table.topic;
    recorded_.push_back(std::move(entry));
  }
  if (selection_.has(world, model, replicate::kind_name(kind))) {
    recorded = true;
    add_standard(world, model);
  }
  if (recorded && replicate::may_be_watched(kind)) measuring_.push_back(id);
}

/// What ROS has messages of its own for.
void Recorder::add_standard(const world::World& world, world::ModelRow model) {
  const world::Models& models = world.models;
  const bool is_root = models.root[model] == model;
  const bool has_frame = is_root && models.mobility[model] != world::Mobility::kFixed;
  switch (models.kind[model]) {
    case scene::ModelKind::kRanger:
      return add_ranger(world, model);
    case scene::ModelKind::kCamera:
      add_channel(world, model, Told::kImage, FrameKind::kLens, "/image");
      add_channel(world, model, Told::kCameraInfo, FrameKind::kLens, "/camera_info");
      return add_frame(world, model, FrameKind::kLens);
    case scene::ModelKind::kImu:
      add_channel(world, model, Told::kImu, FrameKind::kBody, "/data");
      if (!has_frame) add_frame(world, model, FrameKind::kBody);
      return;
    case scene::ModelKind::kGps:
      add_channel(world, model, Told::kFix, FrameKind::kBody, "/fix");
      if (!has_frame) add_frame(world, model, FrameKind::kBody);
      return;
    case scene::ModelKind::kPosition:
      if (!has_frame) return;
      labels_.insert_or_assign(frame_name(label(world, model), FrameKind::kOdometry), world.id(model));
      add_channel(world, model, Told::kOdometry, FrameKind::kOdometry, "/odom");
      return add_frame(world, model, FrameKind::kOdometry);
    default:
      return;
  }
}

void Recorder::add_ranger(const world::World& world, world::ModelRow model) {
  const std::vector<scene::RangerSensorDesc>& sensors = world.desc(model).sensors;
  const bool scans =
      std::ranges::any_of(sensors, [](const scene::RangerSensorDesc& sensor) { return sensor.samples > 1; });
  for (std::uint32_t i = 0; i < sensors.size(); ++i) {
    const std::string number = sensors.size() == 1 ? "" : "_" + std::to_string(i);
    const bool has_rings = sensors[i].rings > 1;
    if (scans) add_channel(world, model, Told::kScan, FrameKind::kRangerSensor, "/scan" + number, i);
    if (has_rings) add_channel(world, model, Told::kCloud, FrameKind::kRangerSensor, "/points" + number, i);
    if (scans || has_rings) add_frame(world, model, FrameKind::kRangerSensor, i);
  }
  if (!scans && !sensors.empty())
    add_channel(world, model, Told::kRanges, FrameKind::kRangerSensor, "/ranges");
}

void Recorder::add_channel(const world::World& world, world::ModelRow model, Told told, FrameKind frame,
                           const std::string& topic, std::uint32_t sensor) {
  const std::string name = label(world, model);
  Recorded entry;
  entry.model = world.id(model);
  entry.told = told;
  entry.sensor = sensor;
  entry.model_frame = name;
  entry.frame = frame_name(name, frame, sensor);
  entry.topic = "/" + name + topic;
  recorded_.push_back(std::move(entry));
}

/// Frames of a robot's sensors are in that of the robot; of what stands, and of odometry, in the world.
void Recorder::add_frame(const world::World& world, world::ModelRow model, FrameKind kind,
                         std::uint32_t sensor) {
  const world::ModelRow top = world.models.root[model];
  const bool is_fixed = world.models.mobility[top] == world::Mobility::kFixed;
  const bool in_world = is_fixed || kind == FrameKind::kOdometry;
  frames_.push_back({.model = world.id(model),
                     .parent = in_world ? world::ModelId{} : world.id(top),
                     .kind = kind,
                     .sensor = sensor,
                     .last = {}});
}

void Recorder::watch_all(world::Journal& journal) {
  for (const world::ModelId model : measuring_) {
    const auto [found, is_new] = watched_.try_emplace(model, control_.generation(model));
    if (!is_new && found->second == control_.generation(model)) continue;
    found->second = control_.generation(model);
    journal.apply(world::changes::Watch{model});
  }
}

// --- events

void Recorder::happened(const world::World& world, const world::Event& event) {
  const world::ModelRow model = world.row(event.model), other = world.row(event.other);
  CdrWriter message;
  message.time(ns());
  message.text(word_of(event.kind));
  message.text(model ? label(world, model) : "");
  message.number(event.model.value);
  message.text(other ? label(world, other) : "");
  put_message(world, "/playhouse/events", kEvent, message.message());
}

void Recorder::changed(const world::World& world, std::span<const world::Change> changes) {
  for (const world::Change& change : changes) record_change(world, change);
  tick_ = world.tick();
  look_around(world);
  record_speech(world);
  hand_over();
}

/// With the tick of the world before it.
void Recorder::record_change(const world::World& world, const world::Change& change) {
  const world::ModelId model = world::model_of(change);
  Bytes packed;
  world::pack(change, packed);
  CdrWriter message;
  message.number(tick_);
  message.text(world::name_of(change));
  message.text(label_of(world, model));
  message.text(world::fields_text(change));
  message.bytes(packed);
  put_message_at(world.time_of(tick_), kChangesTopic, kChange, message.message());
  if (const auto* const load = std::get_if<world::changes::Load>(&change))
    tick_ = world::tick_of(*load->state);
}

void Recorder::ticked(const world::World& world) {
  ++steps_;
  tick_ = world.tick();
  look_around(world);
  const bool is_second = world.tick() % second_ == 0;
  record_poses(world, is_second);
  record_models(world);
  record_speech(world);
  if (is_second) record_check(world);
  if (steps_ - last_state_ >= state_ticks_) record_state(world);
  hand_over();
}

void Recorder::end(const world::World& world) {
  record_check(world);
  hand_over();
}

void Recorder::record_check(const world::World& world) {
  CdrWriter message;
  message.number(world.tick());
  message.number(world.hash());
  message.number(world.sensed_hash());
  put_message(world, "/playhouse/checks", kCheck, message.message());
}

void Recorder::record_state(const world::World& world) {
  last_state_ = steps_;
  if (!runs_again_) return;
  state_.clear();
  if (const Result<void> saved = world::save_whole(world, state_); !saved) return give_up(saved.error());
  CdrWriter message;
  message.number(world.tick());
  message.bytes(state_);
  put_message(world, "/playhouse/states", kState, message.message());
}

/// What moves after a standstill, or jumps, is recorded at the tick before as well: readers interpolate
/// between two transforms, and would have it creep all the while.
void Recorder::record_poses(const world::World& world, bool all) {
  std::vector<Transform> changed, stood;
  for (Framed& frame : frames_) {
    const world::ModelRow row = world.row(frame.model), parent = world.row(frame.parent);
    geom::SpatialPose X = frame_in_world(world, row, frame.kind, frame.sensor);
    if (parent) X = pose_in(world::pose_in_world(world.models, parent), X);
    const bool is_known = !frame.last.child.empty();
    if (!all && X == frame.last.X && is_known) continue;
    if (is_known && !(X == frame.last.X) && steps_ > frame.step + 1) stood.push_back(frame.last);
    frame.step = steps_;
    if (frame.last.child.empty()) {
      frame.last.child = frame_name(label(world, row), frame.kind, frame.sensor);
      frame.last.parent = parent ? label(world, parent) : kWorldFrame;
    }
    frame.last.X = X;
    changed.push_back(frame.last);
  }
  if (!stood.empty()) put_message(world, "/tf", kTransforms, transforms_message(ns(1), stood), 1);
  if (!changed.empty()) put_message(world, "/tf", kTransforms, transforms_message(ns(), changed));
}

/// Sensors: a message per measurement; odometry: at the robot's interval; others: on change.
void Recorder::record_models(const world::World& world) {
  for (Recorded& each : recorded_) {
    const world::ModelRow row = world.row(each.model);
    if (!is_due(world, row, each)) continue;
    const Bytes message = message_of(world, row, each);
    if (message.empty()) continue;
    constexpr std::size_t kTimeEnd = 12;  // after header and time
    const bool on_change = each.told == Told::kTable && !each.table->measures;
    if (on_change && std::ranges::equal(std::span(message).subspan(kTimeEnd), each.last)) continue;
    put_message(world, each.topic, schema_of(each), message);
    if (on_change) each.last.assign(message.begin() + kTimeEnd, message.end());
  }
}

bool Recorder::is_due(const world::World& world, world::ModelRow model, const Recorded& channel) {
  const world::KindRow part = world.models.part[model];
  switch (channel.told) {
    case Told::kTable:
      return !channel.table->measures || channel.table->is_fresh(world, model);
    case Told::kRanges:
    case Told::kScan:
    case Told::kCloud:
      return world.rangers.measured_tick[part] == world.tick();
    case Told::kImage:
    case Told::kCameraInfo:
      return world.cameras.measured_tick[part] == world.tick();
    case Told::kImu:
      return world.imus.measured_tick[part] == world.tick();
    case Told::kFix:
      return world.receivers.measured_tick[part] == world.tick();
    case Told::kOdometry:
      return world.tick() % world::update_ticks(world, model) == 0;
  }
  return false;
}

const char* Recorder::schema_of(const Recorded& channel) {
  switch (channel.told) {
    case Told::kTable:
      return channel.table->schema.c_str();
    case Told::kRanges:
      return kRanges;
    case Told::kScan:
      return kLaserScan;
    case Told::kCloud:
      return kPointCloud;
    case Told::kImage:
      return kImage;
    case Told::kCameraInfo:
      return kCameraInfo;
    case Told::kImu:
      return kImu;
    case Told::kFix:
      return kFix;
    case Told::kOdometry:
      return kOdometry;
  }
  return "";
}

Bytes Recorder::message_of(const world::World& world, world::ModelRow model, const Recorded& channel) const {
  const std::string& frame = channel.frame;
  switch (channel.told) {
    case Told::kTable:
      return channel.table->message(ns(), world, model);
    case Told::kRanges:
      return ranges_message(ns(), world, model);
    case Told::kScan: {
      const world::RangerRow ranger = world.models.part[model];
      const world::SensorRow sensor{world.rangers.first_sensor[ranger] + channel.sensor};
      return scan_message(ns(), frame, world, model, sensor);
    }
    case Told::kCloud:
      return cloud_message(ns(), frame, world, model, channel.sensor);
    case Told::kImage:
      return image_message(ns(), frame, world, model);
    case Told::kCameraInfo:
      return camera_info_message(ns(), frame, world, model);
    case Told::kImu:
      return imu_message(ns(), frame, world, model);
    case Told::kFix:
      return fix_message(ns(), frame, world, model);
    case Told::kOdometry:
      return odometry_message(ns(), frame, channel.model_frame, world, model);
  }
  return {};
}

/// A message for each model that says something else than before, without a text if it is silent now.
void Recorder::record_speech(const world::World& world) {
  if (said_ == world.said() && speakers_ == world.population()) return;
  said_ = world.said();
  speakers_ = world.population();
  std::erase_if(spoken_, [&](const auto& each) { return !world.row(each.first); });
  for (const world::ModelRow row : world.models.rows()) {
    const std::string& text = world.models.say[row];
    const world::ModelId id = world.models.id[row];
    const auto before = spoken_.find(id);
    if (before == spoken_.end() ? text.empty() : before->second == text) continue;
    spoken_[id] = text;
    if (!selection_.has(world, {row}, kSpeechWord)) continue;
    CdrWriter message;
    message.time(ns());
    message.text(label(world, {row}));
    message.number(id.value);
    message.text(text);
    put_message(world, "/playhouse/speech", kSpeech, message.message());
  }
}

}  // namespace playhouse::record
