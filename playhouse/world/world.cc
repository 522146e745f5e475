#include "playhouse/world/world.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

#include "playhouse/base/assert.h"
#include "playhouse/base/limits.h"
#include "playhouse/scene/forms/actuator.h"
#include "playhouse/world/columns.h"
#include "playhouse/world/population/population.h"
#include "playhouse/world/population/rows.h"
#include "playhouse/world/saving/hash_values.h"
#include "playhouse/world/speech.h"

namespace playhouse::world {
namespace {

constexpr std::uint32_t kNone = ModelRow::kNone;

/// Heap memory of a value. [bytes]
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

template <typename T>
PLAYHOUSE_PER_TYPE std::size_t bytes_of_all(const std::vector<T>& values) {
  std::size_t bytes = values.capacity() * sizeof(T);
  for (const T& value : values) bytes += bytes_of(value);
  return bytes;
}
template <typename T>
PLAYHOUSE_PER_TYPE std::size_t bytes_of_all(const SharedColumn<T>& values) {
  std::size_t bytes = values.bytes();
  values.each_kept([&](const T& value) { bytes += bytes_of(value); });
  return bytes;
}

template <typename Values>
PLAYHOUSE_PER_TYPE void add_values(Hash& hash, const World& world, const Values& values, Range range) {
  for (std::uint32_t i = range.begin; i < range.end; ++i) add_value(hash, world, values[i]);
}

/// True if every value is what it begins as.
template <typename Values>
PLAYHOUSE_PER_TYPE bool are_unset(const Values& values, Range range) {
  using T = std::remove_cvref_t<decltype(values[0])>;
  if constexpr (requires(const T& value) { value == T{}; }) {
    for (std::uint32_t i = range.begin; i < range.end; ++i)
      if (!(values[i] == T{})) return false;
    return true;
  }
  return false;
}

template <typename Values>
PLAYHOUSE_PER_TYPE void assign(Values& values, const Values& others) {
  values = others;
}

bool finite(double x, double y, double z, double a) {
  return std::isfinite(x) && std::isfinite(y) && std::isfinite(z) && std::isfinite(a);
}

const scene::PositionDesc& drive_of(const World& world, PositionRow robot) {
  return *world.desc(world.positions.model[robot]).position;
}

/// Clears command and motion of a row of a moving kind.
template <typename Table>
void stop(Table& table, typename Table::Row row) {
  table.mode[row] = ControlMode::kVelocity;
  table.command[row] = {};
  table.velocity[row] = {};
  table.stall[row] = 0;
}
/// Custom models keep their commands: their code knows whether they are used.
void stop(Customs&, CustomRow) {}

/// Records an utterance; entries keep their capacity.
void utter(World& world, ModelRow model, const std::string& text) {
  Utterances& utterances = world.utterances;
  if (utterances.listeners == 0) return;
  if (utterances.newest.empty()) utterances.newest.resize(limits::kUtterances);
  Utterances::One& one = utterances.newest[utterances.count++ % limits::kUtterances];
  one.model = world.id(model);
  one.text = text;
}

}  // namespace

World::World(const scene::SceneDesc& scene, std::uint64_t seed) : scene_(&scene), seed_(seed) {
  if (scene.trees.empty()) made_ = scene::one_of_each(scene);
  trees_ = scene.trees.empty() ? made_ : scene.trees;
  first_like_.assign(scene.models.size(), kNone);
  Population population(*this);
  population.begin(trees_);
  std::vector<std::uint32_t> sizes(
      scene.models.size());  // of prototypes, by row of the top; 0: not known yet
  first_id_.reserve(trees_.size() + 1);
  for (const scene::TreeDesc& tree : trees_) {
    if (sizes[tree.top] == 0) sizes[tree.top] = scene::tree_size(scene, tree.top);
    PLAYHOUSE_ASSERT(sizes[tree.top] > 0);
    const ModelId top{population.next_id()};
    first_id_.push_back(top.value);
    population.append_tree(top, tree.top, sizes[tree.top], tree.X_WM);
    const ModelRow root{top.value};  // ids are rows so far
    models.color.set(root, tree.color);
    models.fiducial_return[root] = tree.fiducial_return;
  }
  first_id_.push_back(population.next_id());
  PLAYHOUSE_ASSERT(made_.empty() || models.size() == scene.models.size());
  for (const ModelRow row : models.rows()) {
    std::uint32_t& first_like = first_like_[models.desc[row]];
    if (first_like == kNone) first_like = row.index;
  }
  population.settle({0});
}

ModelRow World::row(ModelId id) const {
  const std::vector<ModelId>& ids = models.id;
  // If no lower id was removed, the row is the id.
  if (id.value < ids.size() && ids[id.value] == id) return {id.value};
  const auto found = std::ranges::lower_bound(ids, id);
  if (found == ids.end() || *found != id) return {};
  return {static_cast<std::uint32_t>(found - ids.begin())};
}

PositionRow World::position(ModelId id) const {
  const ModelRow model = row(id);
  if (!model || models.kind[model] != scene::ModelKind::kPosition) return {};
  return models.part[model];
}

std::uint32_t World::tree_with(ModelId id) const {
  const auto next = std::ranges::upper_bound(first_id_, id.value);
  return next == first_id_.end() ? kNone : static_cast<std::uint32_t>(next - first_id_.begin()) - 1;
}

World::Origin World::origin(ModelRow row) const {
  const std::uint32_t desc = models.desc[row];
  std::uint32_t top = desc;
  while (scene_->models[top].parent >= 0) top = static_cast<std::uint32_t>(scene_->models[top].parent);
  const ModelId first{models.id[row].value - (desc - top)};
  const std::uint32_t tree = tree_with(first);
  const bool of_scene = tree != kNone && first_id_[tree] == first.value && trees_[tree].top == top;
  return {top, desc - top, first, of_scene ? tree : kNone};
}

std::uint32_t World::like(ModelRow row) const {
  const std::uint32_t id = models.id[row].value, desc = models.desc[row];
  const std::uint32_t tree = tree_with({id});
  if (tree != kNone && trees_[tree].top + (id - first_id_[tree]) == desc) return id;
  // A spawned model may have a description that no scene model has.
  return first_like_[desc] != kNone ? first_like_[desc] : ~desc;
}

config::SourceLine World::where(ModelRow row) const {
  const Origin from = origin(row);
  return from.place == 0 && from.tree != kNone ? trees_[from.tree].where : desc(row).where;
}

std::string World::token(ModelRow row, NameOrAlias which) const {
  const Origin from = origin(row);
  const scene::ModelDesc& model = desc(row);
  const std::string& own = which == NameOrAlias::kName ? model.name : model.alias;
  const std::string& prototype = scene_->models[from.top].name;
  if (from.tree == kNone) {
    const auto given = given_.find(from.first);
    if (given == given_.end()) return own;
    return from.place == 0 ? given->second.name : scene::token_in(own, prototype, given->second.name);
  }
  const scene::TreeDesc& tree = trees_[from.tree];
  if (from.place == 0) return which == NameOrAlias::kName ? tree.name : tree.alias;
  if (const auto renamed = scene_->renamed.find({from.tree, from.place}); renamed != scene_->renamed.end())
    return which == NameOrAlias::kName ? renamed->second.name : renamed->second.alias;
  return scene::token_in(own, prototype, tree.name);
}

std::string World::name(ModelRow row) const {
  return token(row, NameOrAlias::kName);
}

std::string World::alias(ModelRow row) const {
  return token(row, NameOrAlias::kAlias);
}

void World::index_names() const {
  by_name_.clear();
  by_alias_.clear();
  odd_.clear();
  fresh_from_.clear();
  const auto is_below = [](const std::string& token, const std::string& top) {
    return scene::token_in(token, top, "").size() < token.size();
  };
  for (std::uint32_t row = 0, top = 0; row < scene_->models.size(); ++row) {
    const scene::ModelDesc& part = scene_->models[row];
    if (part.parent < 0) {
      top = row;
    } else if (const std::string& name = scene_->models[top].name;
               !is_below(part.name, name) || !is_below(part.alias, name)) {
      odd_.push_back(row);
    }
  }
  names_known_ = true;
  add_names({0});
}

/// Adds the roots from row `first` on.
void World::add_names(ModelRow first) const {
  for (const ModelRow row : RowsOf(first, models.id.next())) {
    if (desc(row).parent >= 0) continue;
    const Origin from = origin(row);
    by_name_.insert({token_of(from, NameOrAlias::kName), from.first});
    if (from.tree != ModelRow::kNone) by_alias_.insert({token_of(from, NameOrAlias::kAlias), from.first});
  }
}

/// Removes a model's names.
void World::remove_names(ModelRow row) const {
  if (!names_known_ || desc(row).parent >= 0) return;
  fresh_from_.clear();
  const Origin from = origin(row);
  by_name_.erase({token_of(from, NameOrAlias::kName), from.first});
  if (from.tree != ModelRow::kNone) by_alias_.erase({token_of(from, NameOrAlias::kAlias), from.first});
}

/// Token of a tree's root; constant during its lifetime.
std::string_view World::token_of(const Origin& from, NameOrAlias which) const {
  if (from.tree != ModelRow::kNone)
    return which == NameOrAlias::kName ? trees_[from.tree].name : trees_[from.tree].alias;
  const auto given = given_.find(from.first);
  return given == given_.end() ? scene_->models[from.top].name : given->second.name;
}

ModelRow World::find(std::string_view token, NameOrAlias which) const {
  ModelRow found;
  const auto take = [&](ModelId id) {
    const ModelRow at = row(id);
    if (at && (!found || at > found) && this->token(at, which) == token) found = at;
  };
  const auto each = [](const std::set<Named>& list, std::string_view wanted, const auto& visit) {
    for (auto at = list.lower_bound({wanted, {0}}); at != list.end() && at->token == wanted; ++at)
      visit(at->id);
  };
  each(which == NameOrAlias::kName ? by_name_ : by_alias_, token, take);
  for (std::size_t dot = token.find('.'); dot != std::string_view::npos; dot = token.find('.', dot + 1)) {
    each(by_name_, token.substr(0, dot), [&](ModelId id) {
      const std::uint32_t top = models.desc[row(id)];
      const std::string wanted = scene_->models[top].name + std::string(token.substr(dot));
      for (std::uint32_t part = top + scene::tree_size(*scene_, top); --part > top;) {
        const scene::ModelDesc& model = scene_->models[part];
        if ((which == NameOrAlias::kName ? model.name : model.alias) == wanted) take({id.value + part - top});
      }
    });
  }
  for (const auto& [place, renamed] : scene_->renamed)
    if ((which == NameOrAlias::kName ? renamed.name : renamed.alias) == token)
      take({first_id_[place.first] + place.second});
  for (const std::uint32_t odd : odd_) {
    const scene::ModelDesc& model = scene_->models[odd];
    if ((which == NameOrAlias::kName ? model.name : model.alias) != token) continue;
    for (const ModelRow at : models.rows())
      if (models.desc[at] == odd) take(models.id[at]);
  }
  return found;
}

/// Given names take precedence over default names, later ones over earlier ones.
ModelRow World::find(std::string_view name) const {
  if (!names_known_) index_names();
  const ModelRow given = find(name, NameOrAlias::kName);
  return given ? given : find(name, NameOrAlias::kAlias);
}

std::uint32_t World::fresh_number(const std::string& name) const {
  if (!names_known_) index_names();
  std::uint32_t& number = fresh_from_.try_emplace(name, 2).first->second;
  while (find(name + "~" + std::to_string(number))) ++number;
  return number;
}

std::uint64_t World::hash_of(ModelRow model, bool (*is_in)(Role)) const {
  Hash hash;
  add_value(hash, *this, models.id[model]);
  each_value_of(
      *this, model,
      [&](const auto& column, const auto& values, Range range) {
        if (!is_in(column.role)) return;
        // So a run in which nobody sets anything has the hash that it had before there was the setting.
        if (column.role == Role::kSetting) {
          if (are_unset(values, range)) return;
          for (const char letter : std::string_view(column.name))
            hash.add(static_cast<std::uint64_t>(letter));
        }
        if (static_cast<const void*>(&values) == &models.desc) return hash.add(std::uint64_t{like(model)});
        add_values(hash, *this, values, range);
      },
      *this);
  return hash.value();
}

std::uint64_t World::hash() const {
  Hash hash;
  hash.add(seed_);
  hash.add(tick_);
  hash.add(std::uint64_t{serial(ModelId{next_id_})});
  std::uint64_t sum = 0;
  for (const ModelRow model : models.rows()) {
    const bool sensed = models.controllers[model] > 0;
    sum +=
        hash_of(model, sensed ? [](Role role) { return is_done(role) || role == Role::kSensed; } : is_done);
  }
  hash.add(sum);
  for (const std::unique_ptr<Decider>& decider : deciders) decider->hash(*this, hash);
  return hash.value();
}

std::uint64_t World::sensed_hash() const {
  Hash hash;
  hash.add(tick_);
  std::uint64_t sum = 0;
  for (const ModelRow model : models.rows())
    sum += hash_of(model, [](Role role) { return role == Role::kSensed || role == Role::kUse; });
  hash.add(sum);
  return hash.value();
}

std::size_t World::bytes() const {
  std::size_t bytes = 0;
  each_column([&](const auto&, const auto& values) { bytes += bytes_of_all(values); }, *this);
  return bytes;
}

geom::SpatialPose pose_in_parent(const Models& models, ModelRow model) {
  return {models.X_PM[model], models.tilt_PM[model]};
}

geom::SpatialPose pose_in_world(const Models& models, ModelRow model) {
  return {models.X_WM[model], models.tilt_WM[model]};
}

void place(Models& models, ModelRow model) {
  const ModelRow parent = models.parent[model];
  const geom::SpatialPose X_PM = pose_in_parent(models, model);
  const geom::SpatialPose X_WM = parent ? geom::compose(pose_in_world(models, parent), X_PM) : X_PM;
  models.X_WM[model] = X_WM.X;
  models.tilt_WM.set(model, X_WM.tilt);
}

void place_tree(World& world, ModelRow model) {
  place(world.models, model);
  of_kind(world.models.kind[model],
          [&]<typename Table>(Table Tables::*table) { moved_in_world(world, world.*table, model); });
  for (const ModelRow child : world.children(model)) place_tree(world, child);
}

bool is_place(const geom::Pose& X) {
  constexpr double kFarthest = 1e9;  // m, as in world files: without risk of overflow
  return finite(X.x, X.y, X.z, X.a) && std::fabs(X.x) <= kFarthest && std::fabs(X.y) <= kFarthest &&
         std::fabs(X.z) <= kFarthest;
}

bool command_velocity(World& world, PositionRow robot, const geom::Twist& velocity) {
  if (!finite(velocity.x, velocity.y, velocity.z, velocity.a)) return false;
  world.positions.mode[robot] = ControlMode::kVelocity;
  world.positions.command[robot] = velocity;
  return true;
}

bool command_position(World& world, PositionRow robot, const geom::Pose& goal_O) {
  if (!is_place(goal_O)) return false;
  world.positions.mode[robot] = ControlMode::kPosition;
  world.positions.goal[robot] = {goal_O.x, goal_O.y, goal_O.z, geom::normalize(goal_O.a)};
  return true;
}

bool command_heading(World& world, PositionRow robot, double speed, double heading_O) {
  if (!finite(speed, 0, 0, heading_O)) return false;
  world.positions.mode[robot] = ControlMode::kHeading;
  world.positions.command[robot] = {speed, 0, 0, geom::normalize(heading_O)};
  return true;
}

bool command_acceleration(World& world, PositionRow robot, const geom::Twist& acceleration) {
  if (!finite(acceleration.x, acceleration.y, acceleration.z, acceleration.a)) return false;
  if (drive_of(world, robot).drive == scene::Drive::kCar) return false;
  world.positions.mode[robot] = ControlMode::kAcceleration;
  world.positions.command[robot] = acceleration;
  return true;
}

bool set_odometry(World& world, PositionRow robot, const geom::Pose& X_OM) {
  if (!is_place(X_OM)) return false;
  const geom::Pose believed{X_OM.x, X_OM.y, X_OM.z, geom::normalize(X_OM.a)};
  const geom::Pose& X_WM = world.models.X_WM[world.positions.model[robot]];
  world.positions.X_OM[robot] = believed;
  world.positions.X_WO[robot] = geom::compose(X_WM, geom::inverse(believed));
  return true;
}

bool set_pose(World& world, ModelRow model, const geom::Pose& X_PM) {
  return set_spatial_pose(world, model, {X_PM, world.models.tilt_PM[model]});
}

bool set_spatial_pose(World& world, ModelRow model, const geom::SpatialPose& X_PM) {
  const geom::Pose& X = X_PM.X;
  if (!is_place(X) || !geom::is_tilt(X_PM.tilt)) return false;
  world.models.X_PM.own(model) = {X.x, X.y, X.z, geom::normalize(X.a)};
  if (!world.upright) world.models.tilt_PM.set(model, X_PM.tilt);
  of_kind(world.models.kind[model],
          [&]<typename Table>(Table Tables::*table) { moved_in_parent(world, world.*table, model); });
  place_tree(world, model);
  world.models.V_WM.set(model, {});
  wake(world.models);
  world.events.add({Event::EventKind::kPlace, world.id(model), {}, 0, world.models.mobility[model]});
  return true;
}

void return_to_start(World& world) {
  const Result<void> detached = detach(world, attached_models(world));
  PLAYHOUSE_ASSERT(detached.ok());
  World start(world.scene(), world.seed());
  Population population(world), at_start(start);
  at_start.clear();
  start.upright = world.upright;
  for (const ModelRow row : world.models.rows())
    at_start.append(world.models.id[row], world.models.desc[row], world.models.parent[row],
                    population.start_of({row}));
  for (const ModelRow row : world.models.rows()) {
    if (pose_in_parent(world.models, {row}) == pose_in_parent(start.models, {row})) continue;
    world.events.add({Event::EventKind::kPlace, world.models.id[row], {}, 0, world.models.mobility[row]});
  }
  each_column(
      [](const auto& column, auto& values, const auto& first_values) {
        if (column.role == Role::kMotion) assign(values, first_values);
      },
      world, start);
  world.models.X_WM = start.models.X_WM;
  world.models.tilt_WM = start.models.tilt_WM;
}

bool command_joint_velocity(World& world, ActuatorRow actuator, double velocity) {
  if (!std::isfinite(velocity)) return false;
  world.actuators.mode[actuator] = ControlMode::kVelocity;
  world.actuators.command[actuator] = velocity;
  return true;
}

bool command_joint_position(World& world, ActuatorRow actuator, double position) {
  if (!std::isfinite(position)) return false;
  const scene::ActuatorDesc& desc = *world.desc(world.actuators.model[actuator]).actuator;
  world.actuators.mode[actuator] = ControlMode::kPosition;
  world.actuators.goal[actuator] = scene::within_reach(desc, position);
  return true;
}

void set_fiducial_return(World& world, ModelRow model, std::int32_t id) {
  world.models.fiducial_return[model] = id;
  world.events.add({Event::EventKind::kSet, world.id(model), {}, 0, world.models.mobility[model]});
}

void set_color(World& world, ModelRow model, const scene::Color& color) {
  world.models.color.set(model, color);
  world.events.add({Event::EventKind::kSet, world.id(model), {}, 0, world.models.mobility[model]});
}

void set_say(World& world, ModelRow model, std::string_view text) {
  if (world.models.say[model] == text) return;
  std::string& says = world.models.say.own(model);
  if (can_be_said(text)) {
    says = text;  // assigned: reuses memory
  } else {
    says = spoken(text);
  }
  ++world.said_;
  if (!says.empty()) utter(world, model, says);
}

void add_flags(World& world, ModelRow model, std::int64_t flags) {
  constexpr std::int64_t kMost = std::numeric_limits<std::int32_t>::max();
  std::int32_t& carried = world.models.flags[model];
  carried += static_cast<std::int32_t>(std::clamp<std::int64_t>(flags, -carried, kMost - carried));
}

void subscribe(World& world, ModelRow model) {
  ++world.models.subscribers[model];
}

void subscribe_controller(World& world, ModelRow model) {
  subscribe(world, model);
  ++world.models.controllers[model];
}

void watch(World& world, ModelRow model) {
  subscribe(world, model);
  ++world.models.watchers[model];
}

void unwatch(World& world, ModelRow model) {
  PLAYHOUSE_ASSERT(world.models.watchers[model] > 0);
  --world.models.watchers[model];
  unsubscribe(world, model);
}

bool is_used(const World& world, ModelRow model) {
  return world.models.subscribers[model] > world.models.watchers[model];
}

void unsubscribe(World& world, ModelRow model) {
  std::uint32_t& subscribers = world.models.subscribers[model];
  PLAYHOUSE_ASSERT(subscribers > 0);
  if (--subscribers > 0) return;
  of_kind(world.models.kind[model], [&]<typename Table>(Table Tables::*table) {
    if constexpr (moves(kKindOf<Table>)) stop(world.*table, world.models.part[model]);
  });
}

}  // namespace playhouse::world
