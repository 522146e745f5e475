#include "playhouse/controllers/batch.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <set>

#include "playhouse/base/in_quotes.h"
#include "playhouse/base/log.h"
#include "playhouse/libraries/libraries.h"

namespace playhouse::controllers {
namespace {

using world::ModelId;
using world::ModelRow;
using world::World;

/// Appends the kind-table rows of all models of one kind in the tree of `model`.
template <typename PartRow>
void collect(const World& world, ModelRow model, scene::ModelKind kind, std::vector<PartRow>& found) {
  if (world.models.kind[model] == kind) found.push_back(world.models.part[model]);
  for (const world::ModelRow child : world.children(model)) collect(world, child, kind, found);
}

/// Heading of a ranger's body frame in its robot. [rad]
double heading_in(const World& world, ModelRow robot, ModelRow ranger) {
  double heading = world.desc(ranger).X_MB.a;
  for (ModelRow at = ranger; at != robot; at = world.models.parent[at]) {
    heading += world.desc(at).X_PM.a;
  }
  return heading;
}

}  // namespace

std::vector<Post> posts_of(const World& world, ModelRow model, std::vector<std::string>* repeated) {
  const std::vector<std::string>& lines = world.desc(model).ctrl;
  std::vector<Post> posts;
  for (std::uint32_t order = 0; order < lines.size(); ++order) {
    const std::vector<std::string> words = libraries::words_of(lines[order]);
    if (words.empty()) continue;
    // Each robot is in a batch once, since its robots are processed in parallel.
    if (std::ranges::find(posts, words[0], &Post::name) != posts.end()) {
      if (repeated) repeated->push_back(words[0]);
      continue;
    }
    posts.push_back({world.id(model), words[0], {words.begin() + 1, words.end()}, order});
  }
  return posts;
}

Result<void> Batch::add(World& world, const Post& post) {
  next_event_ = world.events.end();
  const Result<void> joined = join(world, post);
  if (joined) ids_.push_back(post.model);
  by_id_.clear();
  return joined;
}

std::span<const std::uint32_t> Batch::by_id() {
  if (by_id_.empty()) {
    by_id_.resize(ids_.size());
    std::iota(by_id_.begin(), by_id_.end(), 0u);
    std::ranges::sort(by_id_, {}, [this](std::uint32_t i) { return ids_[i]; });
  }
  return by_id_;
}

void Batch::follow(World& world) {
  using EventKind = world::Event::EventKind;
  bool population = false, reload = false, rebuilt = false;
  const std::uint64_t first = next_event_;
  next_event_ = world.events.end();
  for (const world::Event& event : world.events.since(first)) {
    reload |= event.kind == EventKind::kReload;
    population |= event.kind != EventKind::kPlace && event.kind != EventKind::kSet;
    rebuilt |= event.kind != EventKind::kSet && event.mobility == world::Mobility::kFixed;
  }
  if (population) follow_population(world, first, reload);
  prepare(world, rebuilt);
}

void Batch::follow_population(World& world, std::uint64_t first, bool reload) {
  using EventKind = world::Event::EventKind;
  for (std::size_t i = ids_.size(); i-- > 0;) {
    if (world.row(ids_[i])) {
      resolve(world, i);
    } else {
      leave(i);
      erase_at(i, ids_);
      by_id_.clear();
    }
  }
  // New models are those in the world and not here; unless the
  // state was reloaded, their ids are above all known ones.
  std::set<ModelId> known;
  if (reload) known.insert(ids_.begin(), ids_.end());
  const auto take = [&](ModelId id) {
    const ModelRow model = world.row(id);
    if (!model || world.desc(model).ctrl.empty() || known.contains(id)) return;
    for (const Post& post : posts_of(world, model))
      if (post.name == name_) join_late(world, post);
  };
  if (reload) {
    for (const world::ModelRow row : world.models.rows()) take(world.models.id[row]);
    return;
  }
  const std::vector<world::Event> events(world.events.since(first).begin(), world.events.since(first).end());
  for (const world::Event& event : events)
    for (std::uint32_t i = 0; event.kind == EventKind::kSpawn && i < event.count; ++i)
      take({event.model.value + i});
}

void Batch::join_late(World& world, const Post& post) {
  const Result<void> joined = add(world, post);
  if (joined) return;
  log::error("controller {} of {}: {}", in_quotes(name_), in_quotes(world.name(world.row(post.model))),
             joined.error().line());
}

void Batch::hash(const World& world, Hash& hash) const {
  std::uint64_t sum = 0;
  for (std::size_t i = 0; i < ids_.size(); ++i) {
    Hash one;
    one.add(std::uint64_t{world.serial(ids_[i])});
    hash_of(i, one);
    sum += one.value();
  }
  hash.add(sum);
}

Result<void> Batch::save(Packer& out) const {
  std::vector<std::byte> memory;  // of one robot
  out.varint(ids_.size());
  for (std::size_t i = 0; i < ids_.size(); ++i) {
    out.u32(ids_[i].value);
    memory.clear();
    Packer packer(memory);
    if (const Result<void> saved = save_of(i, packer); !saved) return saved;
    out.bytes(memory);
  }
  return {};
}

/// Skips the memory of a robot whose controller could not be started again: it runs without one.
bool Batch::load(World& world, Unpacker& in) {
  std::map<ModelId, std::size_t> places;
  for (std::size_t i = 0; i < ids_.size(); ++i) places[ids_[i]] = i;
  for (std::uint64_t left = in.varint(); left > 0; --left) {
    const auto place = places.find({in.u32()});
    Unpacker memory(in.bytes(in.varint()));
    if (!in.ok()) return false;
    if (place == places.end()) continue;
    if (!load_of(world, place->second, memory) || !memory.at_end()) return false;
    places.erase(place);
  }
  return true;
}

world::PositionRow position_of(const World& world, ModelRow model) {
  if (world.models.kind[model] != scene::ModelKind::kPosition) return {};
  return world.models.part[model];
}

std::vector<world::RangerRow> rangers_of(const World& world, ModelRow model) {
  std::vector<world::RangerRow> found;
  collect(world, model, scene::ModelKind::kRanger, found);
  return found;
}

world::RangerRow ring_ranger(const World& world, ModelRow model) {
  world::RangerRow best;
  for (const world::RangerRow ranger : rangers_of(world, model)) {
    const std::uint32_t sensors = world.rangers.sensor_count[ranger];
    if (sensors > 0 && (!best || sensors > world.rangers.sensor_count[best])) best = ranger;
  }
  return best;
}

std::vector<world::FiducialRow> finders_of(const World& world, ModelRow model) {
  std::vector<world::FiducialRow> found;
  collect(world, model, scene::ModelKind::kFiducial, found);
  return found;
}

std::vector<float> bearings_of(const World& world, ModelRow robot, world::RangerRow ranger) {
  const ModelRow model = world.rangers.model[ranger];
  const double heading = heading_in(world, robot, model);
  std::vector<float> bearings;
  for (const scene::RangerSensorDesc& sensor : world.desc(model).sensors) {
    for (std::uint32_t k = 0; k < sensor.samples; ++k) {
      const double beam = sensor.samples == 1 ? 0 : sensor.fov * (k / (sensor.samples - 1.0) - 0.5);
      bearings.push_back(static_cast<float>(geom::normalize(heading + sensor.X_BS.a + beam)));
    }
  }
  return bearings;
}

world::BeamRow first_beam(const World& world, world::RangerRow ranger) {
  const world::SensorRow sensor = world.rangers.first_sensor[ranger];
  return world.rangers.sensor_count[ranger] == 0 ? world::BeamRow{0} : world.sensors.first_beam[sensor];
}

std::uint32_t beam_count(const World& world, world::RangerRow ranger) {
  const world::SensorRow first = world.rangers.first_sensor[ranger];
  std::uint32_t beams = 0;
  for (const world::SensorRow k : sensors_of(world.rangers, ranger)) {
    PLAYHOUSE_ASSERT(world.sensors.first_beam[k] == world.sensors.first_beam[first] + beams);
    beams += world.sensors.beam_count[k];
  }
  return beams;
}

}  // namespace playhouse::controllers
