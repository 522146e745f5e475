#include "playhouse/world/world.h"

#include <cmath>
#include <type_traits>

#include "playhouse/base/assert.h"
#include "playhouse/base/hash.h"
#include "playhouse/base/rng.h"
#include "playhouse/world/columns.h"

namespace playhouse::world {
namespace {

constexpr std::uint32_t kNone = ModelRow::kNone;
constexpr std::size_t kUsualHits = 32;  // of a fiducial finder; room for more is made once they are seen

template <typename T>
std::uint32_t count32(const std::vector<T>& column) {
  return static_cast<std::uint32_t>(column.size());
}

void add_model(Models& models, const scene::ModelDesc& desc) {
  const std::uint32_t row = count32(models.X_PM);
  const bool top = desc.parent < 0;
  PLAYHOUSE_ASSERT(top || static_cast<std::uint32_t>(desc.parent) < row);
  const std::uint32_t parent = top ? kNone : static_cast<std::uint32_t>(desc.parent);
  models.X_PM.push_back(desc.X_PM);
  models.X_WM.push_back(top ? desc.X_PM : geom::compose(models.X_WM[parent], desc.X_PM));
  models.parent.push_back(parent);
  models.root.push_back(top ? row : models.root[parent]);
  models.kind.push_back(desc.kind);
  models.part.push_back(kNone);
  models.subscribers.push_back(desc.alwayson ? 1 : 0);
  models.controllers.push_back(0);
  models.fiducial_return.push_back(desc.fiducial_return);
  models.flags.push_back(0);
  models.color.push_back(desc.color);
  models.say.push_back(desc.say);
}

geom::Twist draw_odometry_error(std::uint64_t seed, std::uint32_t model) {
  Rng rng(seed, 0, {Purpose::kOdometryError, model});
  geom::Twist error;
  error.x = rng.uniform(-0.015, 0.015);
  error.y = rng.uniform(-0.015, 0.015);
  error.a = rng.uniform(-0.025, 0.025);
  return error;
}

void add_position(Positions& positions, const scene::PositionDesc& desc, ModelRow model,
                  const geom::Pose& X_WM, std::uint64_t seed) {
  const bool gps = desc.localization == scene::Localization::kGps;
  const geom::Pose X_WO = desc.localization_origin.value_or(gps ? geom::Pose{} : X_WM);
  positions.model.push_back(model);
  positions.mode.push_back(ControlMode::kVelocity);
  positions.command.push_back(desc.velocity);
  positions.goal.push_back({});
  positions.velocity.push_back({});
  positions.X_OM.push_back(geom::compose(geom::inverse(X_WO), X_WM));
  positions.X_WO.push_back(X_WO);
  positions.odom_error.push_back(desc.odom_error.value_or(draw_odometry_error(seed, model.index)));
  positions.stall.push_back(0);
  positions.motor_on.push_back(1);
}

void add_ranger(Rangers& rangers, Sensors& sensors, const scene::ModelDesc& desc, ModelRow model) {
  const RangerRow ranger{count32(rangers.model)};
  rangers.model.push_back(model);
  rangers.first_sensor.push_back(count32(sensors.ranger));
  rangers.sensor_count.push_back(count32(desc.sensors));
  rangers.measured_tick.push_back(0);
  for (const scene::RangerSensorDesc& sensor : desc.sensors) {
    sensors.ranger.push_back(ranger);
    sensors.first_beam.push_back(count32(sensors.ranges));
    sensors.beam_count.push_back(sensor.samples);
    sensors.ranges.insert(sensors.ranges.end(), sensor.samples, static_cast<float>(sensor.range_max));
    sensors.intensities.insert(sensors.intensities.end(), sensor.samples, 0.0f);
  }
}

void add_fiducial(Fiducials& fiducials, ModelRow model) {
  fiducials.model.push_back(model);
  fiducials.hits.emplace_back().reserve(kUsualHits);
  fiducials.measured_tick.push_back(0);
}

// Values of every type that columns have. Bindings name all parts of a value: one more does not compile.

template <typename T>
requires std::is_enum_v<T> || std::is_integral_v<T>
void add(Hash& hash, T value) {
  hash.add(static_cast<std::uint64_t>(value));
}

void add(Hash& hash, float value) {
  hash.add(value);
}

template <typename Table>
void add(Hash& hash, const Row<Table>& row) {
  hash.add(std::uint64_t{row.index});
}

void add(Hash& hash, const geom::Pose& pose) {
  const auto& [x, y, z, a] = pose;
  for (const double value : {x, y, z, a}) hash.add(value);
}

void add(Hash& hash, const geom::Twist& twist) {
  const auto& [x, y, z, a] = twist;
  for (const double value : {x, y, z, a}) hash.add(value);
}

void add(Hash& hash, const scene::Color& color) {
  const auto& [r, g, b, a] = color;
  for (const float value : {r, g, b, a}) hash.add(value);
}

void add(Hash& hash, const std::string& text) {
  hash.add(std::uint64_t{text.size()});
  for (const char letter : text) add(hash, letter);
}

void add(Hash& hash, const FiducialHit& hit) {
  const auto& [target, id, range, bearing, heading, size] = hit;
  const auto& [x, y, z] = size;
  add(hash, target);
  add(hash, id);
  for (const double value : {range, bearing, heading, x, y, z}) hash.add(value);
}

void add(Hash& hash, const std::vector<FiducialHit>& hits) {
  hash.add(std::uint64_t{hits.size()});
  for (const FiducialHit& hit : hits) add(hash, hit);
}

bool is_done(Role role) {
  return role == Role::kFixed || role == Role::kMotion || role == Role::kMark;
}

/// What was measured, in rows [begin, end) of these columns.
template <typename Table>
void add_sensed(Hash& hash, const Table& table, std::size_t begin, std::size_t end) {
  each_column_of<Table>([&](const auto& column) {
    if (column.role != Role::kSensed) return;
    for (std::size_t row = begin; row < end; ++row) add(hash, (table.*column.values)[row]);
  });
}

// Memory that values of columns have elsewhere. [bytes]

template <typename T>
std::size_t bytes_of(const T&) {
  return 0;
}

std::size_t bytes_of(const std::string& text) {
  return text.capacity() > std::string().capacity() ? text.capacity() + 1 : 0;
}

std::size_t bytes_of(const std::vector<FiducialHit>& hits) {
  return hits.capacity() * sizeof(FiducialHit);
}

bool finite(double x, double y, double z, double a) {
  return std::isfinite(x) && std::isfinite(y) && std::isfinite(z) && std::isfinite(a);
}

const scene::PositionDesc& drive_of(const World& world, PositionRow robot) {
  return *world.desc(world.positions.model[robot.index]).position;
}

/// What a robot with gps believes is where it is.
void believe_truth(World& world, std::uint32_t model) {
  if (world.models.kind[model] != scene::ModelKind::kPosition) return;
  const PositionRow robot{world.models.part[model]};
  if (drive_of(world, robot).localization != scene::Localization::kGps) return;
  world.positions.X_OM[robot.index] =
      geom::compose(geom::inverse(world.positions.X_WO[robot.index]), world.models.X_WM[model]);
}

}  // namespace

World::World(const scene::SceneDesc& scene, std::uint64_t seed) : scene_(&scene), seed_(seed) {
  const auto count = static_cast<std::uint32_t>(scene.models.size());
  first_child_.assign(count + 1, 0);
  for (std::uint32_t row = 0; row < count; ++row) {
    const scene::ModelDesc& desc = scene.models[row];
    add_model(models, desc);
    if (desc.kind == scene::ModelKind::kPosition) {
      models.part[row] = count32(positions.model);
      add_position(positions, *desc.position, {row}, models.X_WM[row], seed);
    } else if (desc.kind == scene::ModelKind::kRanger) {
      models.part[row] = count32(rangers.model);
      add_ranger(rangers, sensors, desc, {row});
    } else if (desc.kind == scene::ModelKind::kFiducial) {
      models.part[row] = count32(fiducials.model);
      add_fiducial(fiducials, {row});
    }
    if (desc.parent >= 0) ++first_child_[static_cast<std::uint32_t>(desc.parent) + 1];
    by_name_[desc.alias] = {row};
  }
  // Given names win over default names, later ones over earlier ones.
  for (std::uint32_t row = 0; row < count; ++row) by_name_[scene.models[row].name] = {row};

  for (std::uint32_t row = 0; row < count; ++row) first_child_[row + 1] += first_child_[row];
  child_rows_.resize(first_child_[count]);
  std::vector<std::uint32_t> next(first_child_.begin(), first_child_.end());
  for (std::uint32_t row = 0; row < count; ++row)
    if (models.parent[row] != kNone) child_rows_[next[models.parent[row]]++] = row;
}

ModelRow World::find(std::string_view name) const {
  const auto found = by_name_.find(name);
  return found == by_name_.end() ? ModelRow{} : found->second;
}

std::span<const std::uint32_t> World::children(ModelRow row) const {
  const std::uint32_t begin = first_child_[row.index], end = first_child_[row.index + 1];
  return {child_rows_.data() + begin, end - begin};
}

std::uint64_t World::hash() const {
  Hash hash;
  hash.add(seed_);
  hash.add(tick_);
  each_column(
      [&](const auto& column, const auto& values) {
        if (!is_done(column.role)) return;
        for (const auto& value : values) add(hash, value);
      },
      *this);
  for (std::uint32_t row = 0; row < rangers.size(); ++row) {
    if (models.controllers[rangers.model[row].index] == 0) continue;
    add_sensed(hash, rangers, row, row + 1);
    const std::uint32_t first = rangers.first_sensor[row], end = first + rangers.sensor_count[row];
    for (std::uint32_t sensor = first; sensor < end; ++sensor) {
      const std::uint32_t beam = sensors.first_beam[sensor];
      add_sensed(hash, sensors, beam, beam + sensors.beam_count[sensor]);
    }
  }
  for (std::uint32_t row = 0; row < fiducials.size(); ++row)
    if (models.controllers[fiducials.model[row].index] > 0) add_sensed(hash, fiducials, row, row + 1);
  for (const std::unique_ptr<Decider>& decider : deciders) decider->hash(hash);
  return hash.value();
}

std::uint64_t World::sensed_hash() const {
  Hash hash;
  hash.add(tick_);
  each_column(
      [&](const auto& column, const auto& values) {
        if (is_done(column.role)) return;
        for (const auto& value : values) add(hash, value);
      },
      *this);
  return hash.value();
}

std::size_t World::bytes() const {
  std::size_t bytes = 0;
  each_column(
      [&](const auto&, const auto& values) {
        bytes += values.capacity() * sizeof(values[0]);
        for (const auto& value : values) bytes += bytes_of(value);
      },
      *this);
  return bytes;
}

void place_tree(World& world, ModelRow model) {
  Models& models = world.models;
  const std::uint32_t parent = models.parent[model.index];
  models.X_WM[model.index] = parent == kNone ? models.X_PM[model.index]
                                             : geom::compose(models.X_WM[parent], models.X_PM[model.index]);
  believe_truth(world, model.index);
  for (const std::uint32_t child : world.children(model)) place_tree(world, {child});
}

bool is_place(const geom::Pose& X) {
  constexpr double kFarthest = 1e9;  // m, as in world files: well inside all arithmetic
  return finite(X.x, X.y, X.z, X.a) && std::fabs(X.x) <= kFarthest && std::fabs(X.y) <= kFarthest &&
         std::fabs(X.z) <= kFarthest;
}

bool command_velocity(World& world, PositionRow robot, const geom::Twist& velocity) {
  if (!finite(velocity.x, velocity.y, velocity.z, velocity.a)) return false;
  world.positions.mode[robot.index] = ControlMode::kVelocity;
  world.positions.command[robot.index] = velocity;
  return true;
}

bool command_position(World& world, PositionRow robot, const geom::Pose& goal_O) {
  if (!is_place(goal_O)) return false;
  world.positions.mode[robot.index] = ControlMode::kPosition;
  world.positions.goal[robot.index] = {goal_O.x, goal_O.y, goal_O.z, geom::normalize(goal_O.a)};
  return true;
}

bool command_heading(World& world, PositionRow robot, double speed, double heading_O) {
  if (!finite(speed, 0, 0, heading_O)) return false;
  world.positions.mode[robot.index] = ControlMode::kHeading;
  world.positions.command[robot.index] = {speed, 0, 0, geom::normalize(heading_O)};
  return true;
}

bool command_acceleration(World& world, PositionRow robot, const geom::Twist& acceleration) {
  if (!finite(acceleration.x, acceleration.y, acceleration.z, acceleration.a)) return false;
  if (drive_of(world, robot).drive == scene::Drive::kCar) return false;
  world.positions.mode[robot.index] = ControlMode::kAcceleration;
  world.positions.command[robot.index] = acceleration;
  return true;
}

bool set_odometry(World& world, PositionRow robot, const geom::Pose& X_OM) {
  if (!is_place(X_OM)) return false;
  const geom::Pose believed{X_OM.x, X_OM.y, X_OM.z, geom::normalize(X_OM.a)};
  const geom::Pose& X_WM = world.models.X_WM[world.positions.model[robot.index].index];
  world.positions.X_OM[robot.index] = believed;
  world.positions.X_WO[robot.index] = geom::compose(X_WM, geom::inverse(believed));
  return true;
}

bool set_pose(World& world, ModelRow model, const geom::Pose& X_PM) {
  if (!is_place(X_PM)) return false;
  world.models.X_PM[model.index] = {X_PM.x, X_PM.y, X_PM.z, geom::normalize(X_PM.a)};
  place_tree(world, model);
  world.teleported.push_back(model);
  return true;
}

void return_to_start(World& world) {
  const World start(world.scene(), world.seed());
  for (std::uint32_t row = 0; row < world.models.size(); ++row) {
    if (world.models.X_PM[row] != start.models.X_PM[row]) world.teleported.push_back({row});
  }
  each_column(
      [](const auto& column, auto& values, const auto& first_values) {
        if (column.role == Role::kMotion) values = first_values;
      },
      world, start);
}

void set_fiducial_return(World& world, ModelRow model, std::int32_t id) {
  world.models.fiducial_return[model.index] = id;
}

void set_color(World& world, ModelRow model, const scene::Color& color) {
  world.models.color[model.index] = color;
}

void subscribe(World& world, ModelRow model) {
  ++world.models.subscribers[model.index];
}

void subscribe_controller(World& world, ModelRow model) {
  subscribe(world, model);
  ++world.models.controllers[model.index];
}

void unsubscribe(World& world, ModelRow model) {
  std::uint32_t& subscribers = world.models.subscribers[model.index];
  PLAYHOUSE_ASSERT(subscribers > 0);
  if (--subscribers > 0 || world.models.kind[model.index] != scene::ModelKind::kPosition) return;
  const std::uint32_t robot = world.models.part[model.index];
  world.positions.mode[robot] = ControlMode::kVelocity;
  world.positions.command[robot] = {};
  world.positions.velocity[robot] = {};
  world.positions.stall[robot] = 0;
}

}  // namespace playhouse::world
