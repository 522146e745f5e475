#include "playhouse/world/world.h"

#include <algorithm>
#include <cmath>
#include <type_traits>

#include "playhouse/base/assert.h"
#include "playhouse/base/hash.h"
#include "playhouse/world/columns.h"
#include "playhouse/world/population.h"
#include "playhouse/world/values.h"

namespace playhouse::world {
namespace {

constexpr std::uint32_t kNone = ModelRow::kNone;

template <typename T>
void add(Hash& hash, const T& value) {
  if constexpr (kIsList<T>) {
    hash.add(std::uint64_t{value.size()});
    for (const auto& element : value) add(hash, element);
  } else {
    each_number(value, [&](auto number) {
      if constexpr (std::is_floating_point_v<decltype(number)>) {
        hash.add(number);
      } else {
        hash.add(static_cast<std::uint64_t>(number));
      }
    });
  }
}

/// Memory that a value has elsewhere. [bytes]
template <typename T>
std::size_t bytes_of(const T& value) {
  if constexpr (std::is_same_v<T, std::string>) {
    return value.capacity() > std::string().capacity() ? value.capacity() + 1 : 0;
  } else if constexpr (kIsList<T>) {
    return value.capacity() * sizeof(typename T::value_type);
  } else {
    return 0;
  }
}

/// Hash of the columns of one model that `is_in(column)` chooses, with the model's id.
template <typename Choose>
std::uint64_t hash_of(const World& world, std::uint32_t model, const Choose& is_in) {
  Hash hash;
  add(hash, world.models.id[model]);
  each_value_of(
      world, model,
      [&](const auto& column, const auto& values, Range range) {
        if (!is_in(column)) return;
        for (std::uint32_t i = range.begin; i < range.end; ++i) add(hash, values[i]);
      },
      world);
  return hash.value();
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
  Population population(*this);
  const auto count = static_cast<std::uint32_t>(scene.models.size());
  for (std::uint32_t row = 0; row < count; ++row) {
    const scene::ModelDesc& desc = scene.models[row];
    PLAYHOUSE_ASSERT(desc.parent < static_cast<std::int32_t>(row));
    const ModelRow parent = desc.parent < 0 ? ModelRow{} : ModelRow{static_cast<std::uint32_t>(desc.parent)};
    population.append({row}, row, parent, desc.X_PM);
  }
  population.next_id() = count;
  population.settle(0);
}

ModelRow World::row(ModelId id) const {
  const std::vector<ModelId>& ids = models.id;
  // While nothing below it went, a model's row is its id.
  if (id.value < ids.size() && ids[id.value] == id) return {id.value};
  const auto found = std::ranges::lower_bound(ids, id);
  if (found == ids.end() || *found != id) return {};
  return {static_cast<std::uint32_t>(found - ids.begin())};
}

PositionRow World::position(ModelId id) const {
  const ModelRow model = row(id);
  if (!model || models.kind[model.index] != scene::ModelKind::kPosition) return {};
  return {models.part[model.index]};
}

std::string World::name(ModelRow row) const {
  const std::uint32_t desc = models.desc[row.index];
  std::uint32_t top = desc;
  while (scene_->models[top].parent >= 0) top = static_cast<std::uint32_t>(scene_->models[top].parent);
  const std::string& name = scene_->models[desc].name;
  const auto given = given_.find({models.id[row.index].value - (desc - top)});
  if (given == given_.end()) return name;
  if (desc == top) return given->second.name;
  const std::string prefix = scene_->models[top].name + ".";
  return given->second.name + "." + (name.starts_with(prefix) ? name.substr(prefix.size()) : name);
}

/// Given names win over default names, later ones over earlier ones.
void World::index_names() const {
  by_name_.clear();
  names_known_ = true;
  names_shared_ = false;
  for (std::uint32_t row = 0; row < models.size(); ++row)
    if (models.id[row].value < scene_->models.size()) add_name(desc({row}).alias, models.id[row]);
  add_names(0);
}

/// Those of the models from row `first` on, which are the last.
void World::add_names(std::uint32_t first) const {
  for (std::uint32_t row = first; row < models.size(); ++row) add_name(name({row}), models.id[row]);
}

void World::add_name(const std::string& name, ModelId id) const {
  const auto [place, is_new] = by_name_.try_emplace(name, id);
  if (is_new || place->second == id) return;
  names_shared_ = true;
  place->second = id;
}

/// Of a model that goes. Where names are shared another one may have it then, and all are looked up anew.
void World::remove_names(ModelRow row) const {
  if (names_shared_) names_known_ = false;
  if (!names_known_) return;
  by_name_.erase(name(row));
  if (models.id[row.index].value < scene_->models.size()) by_name_.erase(desc(row).alias);
}

ModelRow World::find(std::string_view name) const {
  if (!names_known_) index_names();
  const auto found = by_name_.find(name);
  return found == by_name_.end() ? ModelRow{} : row(found->second);
}

std::uint64_t World::hash() const {
  Hash hash;
  hash.add(seed_);
  hash.add(tick_);
  hash.add(std::uint64_t{next_id_});
  std::uint64_t sum = 0;
  for (std::uint32_t model = 0; model < models.size(); ++model) {
    const bool sensed = models.controllers[model] > 0;
    sum += hash_of(*this, model, [sensed](const auto& column) {
      return is_done(column.role) || (sensed && column.role == Role::kSensed);
    });
  }
  hash.add(sum);
  for (const std::unique_ptr<Decider>& decider : deciders) decider->hash(hash);
  return hash.value();
}

std::uint64_t World::sensed_hash() const {
  Hash hash;
  hash.add(tick_);
  std::uint64_t sum = 0;
  for (std::uint32_t model = 0; model < models.size(); ++model)
    sum += hash_of(*this, model, [](const auto& column) {
      return column.role == Role::kSensed || column.role == Role::kUse;
    });
  hash.add(sum);
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
  world.changes.add({Change::Kind::kPlace, world.id(model), {}, 0, world.models.mobility[model.index]});
  return true;
}

void return_to_start(World& world) {
  for (std::uint32_t row = 0; row < world.models.size(); ++row) {
    const Result<void> detached = detach(world, world.models.id[row]);
    static_cast<void>(detached);  // most are not attached to anything
  }
  World start(world.scene(), world.seed());
  Population population(world), at_start(start);
  at_start.clear();
  for (std::uint32_t row = 0; row < world.models.size(); ++row)
    at_start.append(world.models.id[row], world.models.desc[row], {world.models.parent[row]},
                    population.start_of({row}));
  for (std::uint32_t row = 0; row < world.models.size(); ++row) {
    if (world.models.X_PM[row] == start.models.X_PM[row]) continue;
    world.changes.add({Change::Kind::kPlace, world.models.id[row], {}, 0, world.models.mobility[row]});
  }
  each_column(
      [](const auto& column, auto& values, const auto& first_values) {
        if (column.role == Role::kMotion) values = first_values;
      },
      world, start);
  world.models.X_WM = start.models.X_WM;
}

void set_fiducial_return(World& world, ModelRow model, std::int32_t id) {
  world.models.fiducial_return[model.index] = id;
  world.changes.add({Change::Kind::kSet, world.id(model), {}, 0, world.models.mobility[model.index]});
}

void set_color(World& world, ModelRow model, const scene::Color& color) {
  world.models.color[model.index] = color;
  world.changes.add({Change::Kind::kSet, world.id(model), {}, 0, world.models.mobility[model.index]});
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
