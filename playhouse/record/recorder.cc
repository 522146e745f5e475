#include "playhouse/record/recorder.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <string_view>

#include "playhouse/base/limits.h"
#include "playhouse/base/log.h"
#include "playhouse/base/packing.h"
#include "playhouse/record/whole_state.h"
#include "playhouse/replicate/views.h"
#include "playhouse/world/periods.h"
#include "playhouse/world/saved_run.h"
#include "playhouse/world/state.h"

namespace playhouse::record {
namespace {

constexpr const char* kWorldFrame = "world";
constexpr const char* kEditsTopic = "/playhouse/edits";

const char* word_of(world::Change::Kind kind) {
  switch (kind) {
    case world::Change::Kind::kSpawn:
      return "came";
    case world::Change::Kind::kDespawn:
      return "went";
    case world::Change::Kind::kAttach:
      return "attached";
    case world::Change::Kind::kDetach:
      return "detached";
    case world::Change::Kind::kPlace:
      return "placed";
    case world::Change::Kind::kSet:
      return "set";
    case world::Change::Kind::kReload:
      return "taken back";
  }
  return "";
}

/// One level of a topic as ROS 2 accepts it: letters and digits, one _ for others between them, no digit first.
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

/// Pose of a model or sensor in another model's frame.
geom::SpatialPose pose_in(const world::World& world, world::ModelRow parent, const geom::SpatialPose& X_WF) {
  if (!parent) return X_WF;
  // Parts of a robot share its tilt: tilts are those of the whole tree.
  return {geom::compose(geom::inverse(world.models.X_WM[parent.index]), X_WF.X), X_WF.tilt};
}

}  // namespace

Recorder::Recorder(RecordThread& file, Selection selection, world::Control& control)
    : file_(file), selection_(std::move(selection)), control_(control) {}

Result<void> Recorder::begin(const world::World& world, const scene::SourceFiles& sources) {
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
  const Attachment start{ns(), kStartName, "application/octet-stream", world::encode(run)};
  if (const Result<void> attached = file_.attach(start); !attached) return attached;
  look_around(world);
  // Reserved before other channels: replay is impossible without it.
  if (runs_again_) channel_of(kEditsTopic, kEdit);
  record_state(world);
  record_poses(world, true);
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
  const std::optional<std::uint16_t> channel = channel_of(topic, schema);
  if (!channel) return;
  const double time = world.time_of(world.tick() - ago);
  const auto published = static_cast<std::uint64_t>(std::llround(time * 1e9));
  put(out_, Message{*channel, sequence_[*channel]++, ns(ago), published, body});
}

void Recorder::hand_over() {
  file_.hand_over(std::exchange(out_, {}));
}

// --- population

/// Models whose names differ in characters that topics lack get a number each: one topic, and frame, for one model.
std::string Recorder::label(const world::World& world, world::ModelRow model) {
  const auto name_of = [&world](world::ModelRow row) {
    std::string name = world.name(row);
    return name.empty() ? world.alias(row) : name;
  };
  const std::string name = name_of(model);
  std::string topic = as_topic(name);
  if (const world::ModelRow top{world.models.root[model.index]}; top != model) {
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

void Recorder::look_around(const world::World& world) {
  if (std::exchange(known_, true) && population_ == world.population()) return;
  population_ = world.population();
  recorded_.clear();
  frames_.clear();
  measuring_.clear();
  for (std::uint32_t row = 0; row < world.models.size(); ++row) add_model(world, {row});
  const bool all_watched = std::ranges::all_of(measuring_, [&](world::ModelId model) {
    const auto found = watched_.find(model);
    return found != watched_.end() && found->second == control_.generation(model);
  });
  // Retries at the next tick if the queue is full.
  if (!all_watched && !control_.post([this](world::World& changing) { watch_all(changing); })) known_ = false;
}

void Recorder::add_model(const world::World& world, world::ModelRow model) {
  const world::Models& models = world.models;
  const scene::ModelKind kind = models.kind[model.index];
  const world::ModelId id = world.id(model);
  if (models.root[model.index] == model.index && models.mobility[model.index] != world::Mobility::kFixed)
    frames_.push_back({.model = id, .parent = {}, .sensor = 0, .is_sensor = false, .last = {}});
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
  if (kind == scene::ModelKind::kRanger && selection_.has(world, model, "ranger")) {
    recorded = true;
    add_ranger(world, model);
  }
  if (kind == scene::ModelKind::kCamera && selection_.has(world, model, "camera")) {
    Recorded entry;
    entry.model = id;
    entry.images = true;
    entry.frame = label(world, world::ModelRow{models.root[model.index]});
    entry.topic = "/" + label(world, model) + "/image";
    recorded_.push_back(std::move(entry));
  }
  if (recorded && replicate::may_be_watched(kind)) measuring_.push_back(id);
}

void Recorder::add_ranger(const world::World& world, world::ModelRow model) {
  const std::uint32_t ranger = world.models.part[model.index];
  const std::uint32_t count = world.rangers.sensor_count[ranger], first = world.rangers.first_sensor[ranger];
  const std::string name = label(world, model);
  const world::ModelRow top{world.models.root[model.index]};
  const bool is_fixed = world.models.mobility[top.index] == world::Mobility::kFixed;
  bool scans = false;
  for (std::uint32_t i = 0; i < count; ++i) scans = scans || world.sensors.beam_count[first + i] > 1;
  for (std::uint32_t i = 0; i < (scans ? count : std::min(count, 1u)); ++i) {
    Recorded entry;
    entry.model = world.id(model);
    entry.sensor = i;
    entry.scans = scans;
    entry.frame = name + "/" + std::to_string(i);
    entry.topic = "/" + name + (!scans ? "/ranges" : count == 1 ? "/scan" : "/scan_" + std::to_string(i));
    recorded_.push_back(std::move(entry));
    if (scans)
      frames_.push_back({.model = world.id(model),
                         .parent = is_fixed ? world::ModelId{} : world.id(top),
                         .sensor = i,
                         .is_sensor = true,
                         .last = {}});
  }
}

void Recorder::watch_all(world::World& world) {
  for (const world::ModelId model : measuring_) {
    const world::ModelRow row = world.row(model);
    const auto [found, is_new] = watched_.try_emplace(model, control_.generation(model));
    if (!row || (!is_new && found->second == control_.generation(model))) continue;
    found->second = control_.generation(model);
    world::watch(world, row);
  }
}

// --- events

void Recorder::follow(const world::World& world, const world::Change& change) {
  const world::ModelRow model = world.row(change.model), other = world.row(change.other);
  CdrWriter message;
  message.time(ns());
  message.text(word_of(change.kind));
  message.text(model ? label(world, model) : "");
  message.number(change.model.value);
  message.text(other ? label(world, other) : "");
  put_message(world, "/playhouse/changes", kWorldChange, message.message());
}

void Recorder::before_changes(const world::World& world) {
  if (!runs_again_) return;
  before_.clear();
  if (const Result<void> saved = save_whole(world, before_); !saved) give_up(saved.error());
}

void Recorder::after_changes(const world::World& world) {
  if (runs_again_) {
    state_.clear();
    const Result<void> saved = save_whole(world, state_);
    if (!saved) {
      give_up(saved.error());
    } else if (state_ != before_) {
      CdrWriter message;
      message.number(Unpacker(std::span(before_).subspan(16)).u64());  // the tick, after size and seed
      message.number(hash_of(before_));
      message.bytes(difference(before_, state_));
      put_message(world, kEditsTopic, kEdit, message.message());
    }
  }
  look_around(world);
  hand_over();
}

void Recorder::ticked(const world::World& world) {
  ++steps_;
  look_around(world);
  const bool is_second = world.tick() % second_ == 0;
  record_poses(world, is_second);
  record_models(world);
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
  if (const Result<void> saved = save_whole(world, state_); !saved) return give_up(saved.error());
  CdrWriter message;
  message.number(world.tick());
  message.bytes(state_);
  put_message(world, "/playhouse/states", kState, message.message());
}

/// What moves after a standstill, or jumps, is recorded at the tick before as well: readers interpolate between
/// two transforms, and would have it creep all the while.
void Recorder::record_poses(const world::World& world, bool all) {
  std::vector<Transform> changed, stood;
  for (Framed& frame : frames_) {
    const world::ModelRow row = world.row(frame.model), parent = world.row(frame.parent);
    geom::SpatialPose X_WF = world::pose_in_world(world.models, row);
    if (frame.is_sensor) {
      const scene::ModelDesc& desc = world.desc(row);
      X_WF.X = geom::compose(geom::compose(X_WF.X, desc.X_MB), desc.sensors[frame.sensor].X_BS);
    }
    geom::SpatialPose X = pose_in(world, parent, X_WF);
    const bool is_known = !frame.last.child.empty();
    if (!all && X == frame.last.X && is_known) continue;
    if (is_known && !(X == frame.last.X) && steps_ > frame.step + 1) stood.push_back(frame.last);
    frame.step = steps_;
    if (frame.last.child.empty()) {
      frame.last.child = label(world, row) + (frame.is_sensor ? "/" + std::to_string(frame.sensor) : "");
      frame.last.parent = parent ? label(world, parent) : kWorldFrame;
    }
    frame.last.X = X;
    changed.push_back(frame.last);
  }
  if (!stood.empty()) put_message(world, "/tf", kTransforms, transforms_message(ns(1), stood), 1);
  if (!changed.empty()) put_message(world, "/tf", kTransforms, transforms_message(ns(), changed));
}

/// Sensors: a message per measurement; others: on change.
void Recorder::record_models(const world::World& world) {
  for (Recorded& each : recorded_) {
    const world::ModelRow row = world.row(each.model);
    if (each.images) {
      if (world.cameras.measured_tick[world.models.part[row.index]] == world.tick())
        put_message(world, each.topic, kImage, image_message(ns(), each.frame, world, row));
      continue;
    }
    if (each.table == nullptr) {
      const std::uint32_t ranger = world.models.part[row.index];
      if (world.rangers.measured_tick[ranger] != world.tick()) continue;
      if (!each.scans) {
        put_message(world, each.topic, kRanges, ranges_message(ns(), world, row));
        continue;
      }
      const world::SensorRow sensor{world.rangers.first_sensor[ranger] + each.sensor};
      put_message(world, each.topic, kLaserScan, scan_message(ns(), each.frame, world, row, sensor));
      continue;
    }
    if (each.table->measures && !each.table->is_fresh(world, row)) continue;
    Bytes message = each.table->message(ns(), world, row);
    constexpr std::size_t kTimeEnd = 12;  // after header and time
    if (!each.table->measures && std::ranges::equal(std::span(message).subspan(kTimeEnd), each.last))
      continue;
    put_message(world, each.topic, each.table->schema, message);
    each.last.assign(message.begin() + kTimeEnd, message.end());
  }
}

}  // namespace playhouse::record
