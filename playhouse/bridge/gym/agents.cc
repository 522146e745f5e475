#include "playhouse/bridge/gym/agents.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "playhouse/base/in_quotes.h"
#include "playhouse/base/rng.h"

namespace playhouse::drivers::gym {
namespace {

/// The columns, in table order.
enum : std::size_t {
  kActions,
  kReset,
  kRanges,
  kPose,
  kOdometry,
  kVelocity,
  kStalled,
  kRangeMost,
  kTick,
  kTime,
  kInterval
};

void put(double* row, const geom::Pose& pose) {
  row[0] = pose.x, row[1] = pose.y, row[2] = pose.a;
}

/// The largest range of its sensors.
float range_most(const world::World& world, world::ModelRow ranger) {
  double most = 0;
  for (const scene::RangerSensorDesc& sensor : world.desc(ranger).sensors)
    most = std::max(most, sensor.range_max);
  return static_cast<float>(most);
}

double radius_of(const scene::ModelDesc& desc) {
  return std::hypot(std::fabs(desc.X_MB.x) + desc.size.x / 2, std::fabs(desc.X_MB.y) + desc.size.y / 2);
}

}  // namespace

Result<void> Agents::begin() {
  find();
  if (agents_.empty()) return Error{"", "no robot of this world has a range finder"};
  beams_ = beams_of(agents_.front());
  const world::World& world = simulation_.world();
  for (const Agent& agent : agents_) {
    if (beams_of(agent) == beams_) continue;
    return Error{"", fmt::format("the range finders of robots differ: {} has {} beams, and {} has {}",
                                 in_quotes(world.name(world.row(agents_.front().model))), beams_,
                                 in_quotes(world.name(world.row(agent.model))), beams_of(agent))};
  }
  const auto count = static_cast<std::uint32_t>(agents_.size());
  const SharedColumns::ColumnFormat columns[] = {
      {"actions", "<f4", count, 3, 4}, {"reset", "|u1", count, 0, 1},     {"ranges", "<f4", count, beams_, 4},
      {"pose", "<f8", count, 3, 8},    {"odometry", "<f8", count, 3, 8},  {"velocity", "<f8", count, 3, 8},
      {"stalled", "|u1", count, 0, 1}, {"range_max", "<f4", count, 0, 4}, {"tick", "<u8", 1, 0, 8},
      {"time", "<f8", 1, 0, 8},        {"interval", "<f8", 1, 0, 8},
  };
  if (const Result<void> made = columns_.make(columns); !made) return made;
  for (std::size_t i = 0; i < agents_.size(); ++i)
    columns_.values<float>(kRangeMost)[i] = range_most(world, world.row(agents_[i].ranger));
  *columns_.values<double>(kInterval) = world.scene().interval;
  simulation_.requests().post_always([this](world::Journal& journal) { use_all(journal); }, {});
  observe();
  return {};
}

void Agents::use_all(world::Journal& journal) {
  for (Agent& agent : agents_) {
    agent.wheels.begin(journal, simulation_.requests(), agent.model);
    agent.sensor.begin(journal, simulation_.requests(), agent.ranger);
  }
}

/// Renews subscriptions: those of re-created agents have ended; those of others are unchanged.
void Agents::use_again(world::Journal& journal) {
  for (Agent& agent : agents_) {
    agent.wheels.end(journal, simulation_.requests());
    agent.sensor.end(journal, simulation_.requests());
  }
  use_all(journal);
}

void Agents::find() {
  const world::World& world = simulation_.world();
  world::ByModel<world::ModelRow> ranger_of(world.models.size());  // first ranger of each tree, by root
  for (const world::ModelRow ranger : world.rangers.model) {
    world::ModelRow& first = ranger_of[world.models.root[ranger]];
    if (!first) first = ranger;
  }
  for (const world::ModelRow model : world.positions.model) {
    if (world.models.root[model] != model || !ranger_of[model]) continue;
    agents_.push_back({.model = world.id(model),
                       .ranger = world.id(ranger_of[model]),
                       .start = world.models.X_PM[model],
                       .radius = radius_of(world.desc(model)),
                       .wheels = {},
                       .sensor = {}});
  }
}

std::uint32_t Agents::beams_of(const Agent& agent) const {
  const world::World& world = simulation_.world();
  const world::RangerRow ranger = world.models.part[world.row(agent.ranger)];
  std::uint32_t beams = 0;
  for (const world::SensorRow sensor : sensors_of(world.rangers, ranger))
    beams += world.sensors.beam_count[sensor];
  return beams;
}

void Agents::reset_all(world::Journal& journal) {
  const world::World& world = journal.world();
  use_again(journal);
  std::vector<std::size_t> place_of(agents_.size());
  for (std::size_t i = 0; i < place_of.size(); ++i) place_of[i] = i;
  Rng rng(world.seed(), world.tick(), {Purpose::kAgentPlace});
  for (std::size_t i = place_of.size(); i > 1; --i) {
    const auto other = static_cast<std::size_t>(rng.uniform() * static_cast<double>(i));
    // Places are exchangeable between robots of equal size.
    if (agents_[place_of[other]].radius == agents_[place_of[i - 1]].radius)
      std::swap(place_of[other], place_of[i - 1]);
  }
  for (std::size_t i = 0; i < agents_.size(); ++i) {
    if (!world.row(agents_[i].model)) continue;
    agents_[i].placed = 0;
    place_at(journal, agents_[i].model, agents_[place_of[i]].start);
  }
  std::memset(columns_.values<std::uint8_t>(kReset), 0, agents_.size());
}

void Agents::act(world::Journal& journal) {
  const world::World& world = journal.world();
  const float* action = columns_.values<float>(kActions);
  auto* reset = columns_.values<std::uint8_t>(kReset);
  for (std::size_t i = 0; i < agents_.size(); ++i, action += 3) {
    if (!world.row(agents_[i].model)) continue;  // removed by a client
    if (reset[i] != 0) {
      place(journal, i);
    } else {
      journal.apply(world::changes::Drive{agents_[i].model, {action[0], action[1], 0, action[2]}});
    }
  }
  std::memset(reset, 0, agents_.size());
}

void Agents::place(world::Journal& journal, std::size_t i) {
  const world::World& world = journal.world();
  Agent& agent = agents_[i];
  Rng rng(world.seed(), world.tick(), {Purpose::kAgentPlace, world.serial(agent.model), 0, ++agent.placed});
  const std::size_t first = static_cast<std::size_t>(rng.uniform() * static_cast<double>(agents_.size()));
  for (std::size_t tried = 0; tried < agents_.size(); ++tried) {
    const geom::Pose& at = agents_[(first + tried) % agents_.size()].start;
    if (is_free(at, i)) return place_at(journal, agent.model, at);
  }
  journal.apply(world::changes::Stand{agent.model});  // all are occupied: it stays
}

/// There it stands.
void Agents::place_at(world::Journal& journal, world::ModelId model, const geom::Pose& at) {
  journal.apply(world::changes::Place{model, at});
  journal.apply(world::changes::Stand{model});
}

bool Agents::is_free(const geom::Pose& at, std::size_t i) const {
  const world::World& world = simulation_.world();
  for (std::size_t other = 0; other < agents_.size(); ++other) {
    const world::ModelRow row = world.row(agents_[other].model);
    if (other == i || !row) continue;
    const geom::Pose& X_WM = world.models.X_WM[row];
    const double room = agents_[i].radius + agents_[other].radius;
    const double dx = X_WM.x - at.x, dy = X_WM.y - at.y;
    if (dx * dx + dy * dy < room * room) return false;
  }
  return true;
}

void Agents::observe() {
  const world::World& world = simulation_.world();
  for (std::size_t i = 0; i < agents_.size(); ++i) {
    const world::ModelRow model = world.row(agents_[i].model), ranger = world.row(agents_[i].ranger);
    if (!model || !ranger) continue;
    const world::PositionRow robot = world.models.part[model];
    const world::SensorRow sensor = world.rangers.first_sensor[world.models.part[ranger]];
    std::copy_n(world.sensors.ranges.from(world.sensors.first_beam[sensor]), beams_,
                columns_.values<float>(kRanges) + i * beams_);
    put(columns_.values<double>(kPose) + 3 * i, world.models.X_WM[model]);
    put(columns_.values<double>(kOdometry) + 3 * i, world.positions.X_OM[robot]);
    const geom::Twist& velocity = world.positions.velocity[robot];
    double* const row = columns_.values<double>(kVelocity) + 3 * i;
    row[0] = velocity.x, row[1] = velocity.y, row[2] = velocity.a;
    columns_.values<std::uint8_t>(kStalled)[i] = world.positions.stall[robot];
  }
  *columns_.values<std::uint64_t>(kTick) = world.tick();
  *columns_.values<double>(kTime) = world.time();
}

}  // namespace playhouse::drivers::gym
