#include "playhouse/world/population/population.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <utility>
#include <vector>

#include "playhouse/base/assert.h"
#include "playhouse/base/in_quotes.h"
#include "playhouse/base/limits.h"
#include "playhouse/mesh/mesh.h"
#include "playhouse/scene/forms/camera.h"
#include "playhouse/world/columns.h"
#include "playhouse/world/generated/worded.h"
#include "playhouse/world/population/rows.h"
#include "playhouse/world/speech.h"

namespace playhouse::world {
namespace {

constexpr std::uint32_t kNone = ModelRow::kNone;
constexpr std::size_t kUsualItems = 32;  // reserved list capacity

template <typename T>
std::uint32_t count32(const std::vector<T>& column) {
  return static_cast<std::uint32_t>(column.size());
}

/// Appends a zero; reserves typical capacity for lists.
template <typename Values>
PLAYHOUSE_PER_TYPE void add_value(Values& values) {
  auto& value = values.emplace_back();
  if constexpr (requires { value.reserve(kUsualItems); }) value.reserve(kUsualItems);
}

/// Appends a row of zeros to a table.
template <typename Table>
void add_row(Table& table) {
  each_column_of<Table>([&](const auto& column) { add_value(column.of(table)); });
}

template <typename Values>
PLAYHOUSE_PER_TYPE void clear(Values& values) {
  values.clear();
}

template <typename T>
PLAYHOUSE_PER_TYPE void make_room(std::vector<T>& values, std::size_t count) {
  values.reserve(count);
}
/// Shared columns grow with what differs from the prototypes.
template <typename T>
void make_room(SharedColumn<T>&, std::size_t) {}

/// True if it or an ancestor is a mover.
bool is_driven(const Models& models, ModelRow row) {
  while (row && !moves(models.kind[row])) row = models.parent[row];
  return row.valid();
}

/// True if the model or a descendant is driven.
bool holds_driven(const World& world, ModelRow row) {
  if (world.models.mobility[row] == Mobility::kDriven) return true;
  for (const ModelRow child : world.children(row))
    if (holds_driven(world, child)) return true;
  return false;
}

/// True for an attached model: a part that is a root in the scene.
bool was_attached(const World& world, ModelRow row) {
  return world.models.parent_id[row].valid() && world.desc(row).parent < 0;
}

std::size_t corners_of(const scene::ModelDesc& desc) {
  std::size_t corners = 0;
  for (const scene::Block& block : desc.blocks) corners += block.points.size();
  for (const scene::Contours& bitmap : desc.bitmaps)
    for (const auto& loop : bitmap.loops) corners += loop.size();
  return corners;
}

std::size_t pixels_of(const scene::ModelDesc& desc) {
  return desc.camera ? scene::kept_pixels_of(*desc.camera) : 0;
}

/// Range of a table for consecutive models; empty if they have no rows.
template <typename Table>
Range range_of_run(const Tables& tables, RowsOf<ModelTable> models, Per per) {
  Range all;
  for (const ModelRow model : models) {
    const Range own = range_of<Table>(tables, model, per);
    if (own.begin < own.end) all = {all.begin < all.end ? all.begin : own.begin, own.end};
  }
  return all;
}

/// Removes ascending ranges, some empty; each remaining value moves once.
template <typename T>
PLAYHOUSE_PER_TYPE void erase_ranges(std::vector<T>& values, std::span<const Range> ranges) {
  const auto at = [&](std::uint32_t index) { return values.begin() + index; };
  auto to = values.end();
  std::uint32_t from = 0;  // first remaining value after a removal
  for (const Range& range : ranges) {
    if (range.begin == range.end) continue;
    to = to == values.end() ? at(range.begin) : std::move(at(from), at(range.begin), to);
    from = range.end;
  }
  if (to != values.end()) values.erase(std::move(at(from), values.end(), to), values.end());
}

template <typename T>
PLAYHOUSE_PER_TYPE void erase_ranges(SharedColumn<T>& values, std::span<const Range> ranges) {
  values.erase(ranges);
}

Error no_model() {
  return Error{{}, "there is no such model, or no more"};
}

/// Turns a model by the roll and pitch of its description. False if it has neither.
bool tilt_by_desc(World& world, ModelRow row, const geom::Pose& upright_PM) {
  const scene::ModelDesc& desc = world.desc(row);
  if (desc.roll == 0 && desc.pitch == 0) return false;
  const geom::SpatialPose X_PM = tilted(desc, upright_PM);
  world.models.X_PM.set(row, X_PM.X);
  world.models.tilt_PM.set(row, X_PM.tilt);
  return true;
}

}  // namespace

void Population::clear() {
  each_column([](const auto&, auto& values) { world::clear(values); }, world_);
  world_.next_id_ = 0;
  world_.serials_.clear();
  world_.corners_ = world_.pixels_ = 0;
  world_.given_.clear();
  world_.names_known_ = false;
}

void Population::begin(std::span<const scene::TreeDesc> trees) {
  const std::vector<scene::ModelDesc>& descs = world_.scene().models;
  std::vector<geom::Pose> poses;
  std::vector<scene::Color> colors;
  std::vector<std::string> says;
  for (const scene::ModelDesc& desc : descs) {
    poses.push_back(desc.X_PM);
    colors.push_back(desc.color);
    says.push_back(spoken(desc.say));
  }
  world_.models.X_PM.set_prototypes(std::move(poses));
  world_.models.color.set_prototypes(std::move(colors));
  world_.models.say.set_prototypes(std::move(says));
  world_.models.drawing.set_prototypes(std::vector<std::vector<DrawnCorner>>(descs.size()));
  world_.models.tilt_PM.set_prototypes(std::vector<geom::Tilt>(descs.size()));
  world_.models.tilt_WM.set_prototypes(std::vector<geom::Tilt>(descs.size()));
  world_.models.V_WM.set_prototypes(std::vector<geom::SpatialVelocity>(descs.size()));
  world_.models.still.set_prototypes(std::vector<std::uint32_t>(descs.size()));

  std::vector<std::size_t> count(descs.size());  // of trees, by row of their root
  for (const scene::TreeDesc& tree : trees) ++count[tree.top];
  std::size_t models = 0, sensors = 0, beams = 0;
  std::map<scene::ModelKind, std::size_t> of_kind;
  for (std::size_t row = 0, trees_of_it = 0; row < descs.size(); ++row) {
    const scene::ModelDesc& desc = descs[row];
    if (desc.parent < 0) trees_of_it = count[row];
    models += trees_of_it;
    of_kind[desc.kind] += trees_of_it;
    sensors += trees_of_it * desc.sensors.size();
    for (const scene::RangerSensorDesc& sensor : desc.sensors) beams += trees_of_it * sensor.samples;
  }
  const auto make_room = [&]<typename Table>(Table Tables::*table, std::size_t rows) {
    each_column_of<Table>([&](const auto& column) {
      world::make_room(column.of(world_.*table), column.per == Per::kBeam ? beams : rows);
    });
  };
  world_.models.X_PM.reserve(models);
  make_room(&Tables::models, models);
  make_room(&Tables::sensors, sensors);
  each_kind_table([&]<typename Table>(Table Tables::*table) { make_room(table, of_kind[kKindOf<Table>]); });
  each_trait_table([&]<typename Table>(Table Tables::*table) {
    std::size_t rows = 0;
    for (std::size_t row = 0, trees_of_it = 0; row < descs.size(); ++row) {
      if (descs[row].parent < 0) trees_of_it = count[row];
      if (kHas<Table>(descs[row])) rows += trees_of_it;
    }
    make_room(table, rows);
  });
}

ModelRow Population::append(ModelId id, std::uint32_t desc_row, ModelRow parent, const geom::Pose& X_PM) {
  Models& models = world_.models;
  const scene::ModelDesc& desc = world_.scene().models[desc_row];
  const ModelRow row = models.id.next();
  const bool top = !parent;
  models.id.push_back(id);
  models.desc.push_back(desc_row);
  models.parent_id.push_back(top ? ModelId{} : models.id[parent]);
  models.parent.push_back(parent);
  models.X_PM.set(row, X_PM);
  if (!world_.upright) tilt_by_desc(world_, row, X_PM);
  models.X_WM.push_back({});
  place(models, row);
  models.root.push_back(top ? row : models.root[parent]);
  models.kind.push_back(desc.kind);
  models.part.push_back({});
  models.first_child.push_back({});
  models.next_sibling.push_back({});
  models.mobility.push_back(Mobility::kFixed);
  models.subscribers.push_back(desc.alwayson ? 1 : 0);
  models.controllers.push_back(0);
  models.watchers.push_back(0);
  models.fiducial_return.push_back(desc.fiducial_return);
  models.flags.push_back(0);
  // Own values for columns written by phases: parallel and without allocation.
  if (top || moves(desc.kind)) models.X_PM.own(row);
  if (!desc.ctrl.empty()) models.say.own(row);
  world_.corners_ += corners_of(desc);
  world_.pixels_ += pixels_of(desc);
  add_part(row);
  return row;
}

void Population::append_tree(ModelId top, std::uint32_t desc, std::uint32_t count, const geom::Pose& X_WM) {
  const ModelRow first = append(top, desc, {}, X_WM);
  for (std::uint32_t i = 1; i < count; ++i) {
    const scene::ModelDesc& part = world_.scene().models[desc + i];
    append({top.value + i}, desc + i, first + (static_cast<std::uint32_t>(part.parent) - desc), part.X_PM);
  }
  next_id() = top.value + count;
}

void Population::add_part(ModelRow row) {
  const scene::ModelDesc& desc = world_.desc(row);
  of_kind(desc.kind, [&]<typename Table>(Table Tables::*member) {
    Table& table = world_.*member;
    world_.models.part[row] = {table.model.next().index};
    add_row(table);
    table.model.back() = row;
    begin_as_said(table, desc);
    fill_row(world_, table, desc, row);
  });
  each_trait_table([&]<typename Table>(Table Tables::*member) {
    if (!kHas<Table>(desc)) return;
    Table& table = world_.*member;
    add_row(table);
    table.model.back() = row;
    fill_row(world_, table, desc, row);
  });
}

void Population::erase(std::span<const RowsOf<ModelTable>> runs) {
  for (const RowsOf<ModelTable> run : runs)
    for (const ModelRow row : run) {
      world_.corners_ -= corners_of(world_.desc(row));
      world_.pixels_ -= pixels_of(world_.desc(row));
      world_.remove_names(row);
    }
  std::vector<Range> rows, beams;
  const auto erase_from = [&]<typename Table>(Table Tables::*table) {
    // Tables are in model order, so consecutive models have consecutive rows.
    rows.clear(), beams.clear();
    for (const RowsOf<ModelTable> run : runs) {
      rows.push_back(range_of_run<Table>(world_, run, Per::kRow));
      beams.push_back(range_of_run<Table>(world_, run, Per::kBeam));
    }
    each_column_of<Table>([&](const auto& column) {
      erase_ranges(column.of(world_.*table), column.per == Per::kBeam ? beams : rows);
    });
  };
  // In reverse order of tables: rows of later tables are found through earlier ones.
  [&]<std::size_t... I>(std::index_sequence<I...>) {
    (erase_from(std::get<sizeof...(I) - 1 - I>(kTables)), ...);
  }
  (std::make_index_sequence<std::tuple_size_v<decltype(kTables)>>());
}

Result<void> Population::check_room(std::span<const std::uint32_t> descs) const {
  std::size_t models = world_.models.size(), sensors = world_.sensors.size(),
              beams = world_.sensors.ranges.size() + world_.pixels_, corners = world_.corners_;
  for (const std::uint32_t row : descs) {
    const scene::ModelDesc& desc = world_.scene().models[row];
    ++models;
    sensors += desc.sensors.size();
    for (const scene::RangerSensorDesc& sensor : desc.sensors) beams += sensor.samples;
    beams += pixels_of(desc);
    corners += corners_of(desc);
    const bool has_room = models <= limits::kModels && sensors <= limits::kSensors &&
                          beams <= limits::kBeams && corners <= limits::kCorners;
    if (!has_room)
      return Error{{}, "the world is full: it has " + std::to_string(world_.models.size()) + " models"};
  }
  return {};
}

/// Rangers among the models from a row on.
RowsOf<RangerTable> rangers_from(const Rangers& rangers, ModelRow first) {
  const auto found = std::ranges::lower_bound(rangers.model, first);
  return {{static_cast<std::uint32_t>(found - rangers.model.begin())}, rangers.model.next()};
}

/// Ids ascend with rows: the models that came are the last ones, and so are their sensors and beams.
Result<void> check_budget(const World& world) {
  const std::vector<ModelId>& ids = world.models.id;
  const auto first = std::ranges::lower_bound(ids, Population::first_of_run(world));
  const ModelRow row{static_cast<std::uint32_t>(first - ids.begin())};
  std::size_t sensors = 0, beams = 0;
  for (const RangerRow each : rangers_from(world.rangers, row)) {
    if (sensors > 0) break;
    if (world.rangers.sensor_count[each] == 0) continue;
    const SensorRow sensor = world.rangers.first_sensor[each];
    sensors = world.sensors.ranger.next() - sensor;
    beams = world.sensors.ranges.next() - world.sensors.first_beam[sensor];
  }
  const std::size_t models = world.models.id.next() - row;
  if (models < limits::kBroughtModels && sensors < limits::kBroughtSensors && beams < limits::kBroughtBeams)
    return {};
  return Error{{},
               "the run is full: " + std::to_string(models) + " models with " + std::to_string(sensors) +
                   " sensors and " + std::to_string(beams) + " beams came"};
}

bool Population::derive() {
  if (!derive_trees()) return false;
  derive_parts();
  note_change({0});
  return true;
}

bool Population::derive_trees() {
  Models& models = world_.models;
  std::ranges::fill(models.first_child, ModelRow{});
  std::ranges::fill(models.next_sibling, ModelRow{});
  for (const ModelRow row : models.rows()) {
    const ModelId parent = models.parent_id[row];
    models.parent[row] = parent ? world_.row(parent) : ModelRow{};
    if (parent && !models.parent[row]) return false;
  }
  link({0});
  for (const ModelRow row : models.rows()) {
    ModelRow top = row;
    for (int depth = 0; models.parent[top]; top = models.parent[top])
      if (++depth > limits::kTreeDepth) return false;
    models.root[row] = top;
  }
  return true;
}

void Population::link(ModelRow first) {
  Models& models = world_.models;
  // In reverse order of rows, so that siblings end up ascending.
  for (ModelRow row = models.id.next(); row > first;) {
    --row;
    const ModelRow parent = models.parent[row];
    if (!parent) continue;
    models.next_sibling[row] = models.first_child[parent];
    models.first_child[parent] = row;
  }
}

void Population::derive_parts() {
  Models& models = world_.models;
  for (const ModelRow row : models.rows()) {
    models.kind[row] = world_.desc(row).kind;
    models.part[row] = {};
  }
  each_kind_table([&]<typename Table>(Table Tables::*member) {
    auto& model = (world_.*member).model;
    auto part = model.rows().front();
    for (const ModelRow row : models.rows()) {
      if (models.kind[row] != kKindOf<Table>) continue;
      model[part] = row;
      models.part[row] = {part.index};
      ++part;
    }
  });
  each_trait_table([&]<typename Table>(Table Tables::*member) {
    auto next = (world_.*member).model.begin();
    for (const ModelRow row : models.rows())
      if (kHas<Table>(world_.desc(row))) *next++ = row;
  });
  SensorRow sensor{0};
  BeamRow beam{0};
  for (const RangerRow ranger : world_.rangers.rows()) {
    world_.rangers.first_sensor[ranger] = sensor;
    for (const scene::RangerSensorDesc& each : world_.desc(world_.rangers.model[ranger]).sensors) {
      world_.sensors.ranger[sensor] = ranger;
      world_.sensors.first_beam[sensor] = beam;
      beam = beam + each.samples;
      ++sensor;
    }
  }
}

/// What is carried by something that moves is driven. The rest of a tree is loose if any of it can be lifted
/// or if it came during the run, unless it has a bitmap, which only walls have. A mesh may say which it is.
void Population::derive_mobility(ModelRow first) {
  Models& models = world_.models;
  for (const ModelRow row : RowsOf(first, models.id.next())) {
    const bool came = models.root[row] == row && models.id[row].value >= world_.first_id_.back();
    models.mobility[row] = came ? Mobility::kLoose : Mobility::kFixed;
  }
  for (const ModelRow row : RowsOf(first, models.id.next())) {
    if (is_driven(models, row)) continue;
    Mobility& top = models.mobility[models.root[row]];
    const scene::ModelDesc& desc = world_.desc(row);
    if (desc.gripper_return) top = Mobility::kLoose;
    if (!desc.bitmaps.empty()) top = Mobility::kFixed;
    if (desc.mesh && desc.mesh->physics)
      top = desc.mesh->physics->is_fixed ? Mobility::kFixed : Mobility::kLoose;
  }
  for (const ModelRow row : RowsOf(first, models.id.next())) {
    const bool driven = is_driven(models, row);
    if (driven || models.root[row] != row)
      models.mobility[row] = driven ? Mobility::kDriven : models.mobility[models.root[row]];
  }
}

void Population::settle(ModelRow first) {
  link(first);
  note_change(first);
}

void Population::note_change(ModelRow first) {
  derive_mobility(first);
  ++world_.population_;
}

void Population::add_names(ModelRow first) {
  if (world_.names_known_) world_.add_names(first);
}

geom::Pose Population::start_of(ModelRow row) const {
  const World::Origin from = world_.origin(row);
  if (from.place > 0) return world_.desc(row).X_PM;
  if (from.tree != kNone) return world_.trees_[from.tree].X_WM;
  const auto given = world_.given_.find(from.first);
  return given == world_.given_.end() ? world_.desc(row).X_PM : given->second.X_WM;
}

geom::SpatialPose tilted(const scene::ModelDesc& desc, const geom::Pose& X_PM) {
  const geom::SpatialPose turned = geom::spatial_pose({}, geom::RollPitchYaw{desc.roll, desc.pitch, 0});
  return {{X_PM.x, X_PM.y, X_PM.z, geom::normalize(X_PM.a + turned.X.a)}, turned.tilt};
}

void tilt_as_described(World& world) {
  world.upright = false;
  for (const ModelRow row : world.models.rows()) {
    const bool is_joint = world.models.kind[row] == scene::ModelKind::kActuator;
    const bool is_tilted = tilt_by_desc(world, row, pose_said(world, row));
    if (is_tilted && is_joint)
      set_joint(world, world.models.part[row], pose_in_parent(world.models, row));
    else
      place(world.models, row);  // after its parent
  }
  for (const PositionRow robot : world.positions.rows()) begin_odometry(world, robot);
}

std::string fresh_name(const World& world, std::string_view like) {
  const std::size_t tilde = like.rfind('~');
  const bool is_numbered = tilde != std::string_view::npos && tilde + 1 < like.size() &&
                           like.find_first_not_of("0123456789", tilde + 1) == std::string_view::npos;
  const std::string name(is_numbered ? like.substr(0, tilde) : like);
  return name + "~" + std::to_string(world.fresh_number(name));
}

Result<ModelId> spawn(World& world, std::uint32_t prototype, const geom::Pose& X_WM, std::string name) {
  const std::uint32_t count = scene::tree_size(world.scene(), prototype);
  if (count == 0) return Error{{}, "there is no such prototype"};
  if (!is_place(X_WM)) return Error{{}, "invalid pose: not finite, or too far away"};
  Population population(world);
  std::vector<std::uint32_t> descs(count);
  std::iota(descs.begin(), descs.end(), prototype);
  if (const Result<void> room = population.check_room(descs); !room) return room.error();
  if (population.next_id() > ModelId::kNone - count) return Error{{}, "the run has no more ids to give"};
  if (name.empty()) {
    name = fresh_name(world, world.scene().models[prototype].name);
  } else if (world.find(name)) {
    return Error{{}, "there is a model " + in_quotes(name) + " already"};
  }

  const geom::Pose X{X_WM.x, X_WM.y, X_WM.z, geom::normalize(X_WM.a)};
  const ModelId top{population.next_id()};
  const ModelRow first = world.models.id.next();
  population.given()[top] = {std::move(name), X};
  population.append_tree(top, prototype, count, X);
  population.settle(first);
  population.add_names(first);
  world.events.add({Event::EventKind::kSpawn, top, {}, count, world.models.mobility[first]});
  return top;
}

Result<ModelId> spawn_like(World& world, ModelRow model, geom::Pose X_WM, std::string name) {
  const ModelRow top = world.models.root[model];
  X_WM.z = world.models.X_PM[top].z;
  if (name.empty()) name = fresh_name(world, world.name(top));
  const Result<ModelId> came = spawn(world, world.models.desc[top], X_WM, std::move(name));
  if (!came) return came;
  // Copies the per-tree values.
  const ModelRow row = world.row(*came);
  set_color(world, row, world.models.color[top]);
  set_fiducial_return(world, row, world.models.fiducial_return[top]);
  return came;
}

namespace {

Error named_twice() {
  return {{}, "it is named twice"};
}

bool is_any_named_twice(std::vector<ModelId> models) {
  std::ranges::sort(models);
  return std::ranges::adjacent_find(models) != models.end();
}

/// Rows of the roots to remove, ascending.
Result<std::vector<ModelRow>> tops_to_go(const World& world, std::span<const ModelId> models) {
  std::vector<ModelRow> tops;
  for (const ModelId model : models) {
    const ModelRow row = world.row(model);
    if (!row) return no_model();
    if (world.models.parent_id[row]) return Error{{}, "it is a part of another model"};
    tops.push_back(row);
  }
  std::ranges::sort(tops);
  if (std::ranges::adjacent_find(tops) != tops.end()) return named_twice();
  return tops;
}

/// Detaches all models attached anywhere in these trees.
void detach_from(World& world, std::span<const ModelRow> tops) {
  std::vector<ModelId> attached;
  for (const ModelRow part : world.models.rows()) {
    const bool goes = std::ranges::binary_search(tops, world.models.root[part]);
    if (goes && was_attached(world, part)) attached.push_back(world.models.id[part]);
  }
  const Result<void> detached = detach(world, attached);
  PLAYHOUSE_ASSERT(detached.ok());
}

}  // namespace

Result<void> despawn(World& world, ModelId model) {
  return despawn(world, std::span(&model, 1));
}

Result<void> despawn(World& world, std::span<const ModelId> models) {
  const Result<std::vector<ModelRow>> tops = tops_to_go(world, models);
  if (!tops) return tops.error();
  detach_from(world, *tops);
  const auto count_of = [&](ModelRow top) { return scene::tree_size(world.scene(), world.models.desc[top]); };
  for (const ModelId model : models) {
    const ModelRow top = world.row(model);
    world.events.add({Event::EventKind::kDespawn, model, {}, count_of(top), world.models.mobility[top]});
  }
  std::vector<RowsOf<ModelTable>> runs;  // trees have consecutive ids, hence consecutive rows
  for (const ModelRow top : *tops) runs.push_back({top, top + count_of(top)});
  Population population(world);
  population.erase(runs);
  for (const ModelId model : models) population.given().erase(model);
  const bool derived = population.derive();
  PLAYHOUSE_ASSERT(derived);
  wake(world.models);
  return {};
}

namespace {

/// Why a model cannot be attached to the parent at this pose, if it can't.
Result<void> check_attachment(const World& world, const AttachedChild& attachment, ModelRow parent) {
  const ModelRow child = world.row(attachment.child);
  if (!child) return no_model();
  const Models& models = world.models;
  if (!is_place(attachment.X_PC)) return Error{{}, "invalid pose: not finite, or too far away"};
  if (models.parent_id[child]) return Error{{}, "it is a part of another model"};
  if (models.root[parent] == child) return Error{{}, "it cannot be a part of itself"};
  if (models.mobility[child] != Mobility::kLoose || holds_driven(world, child))
    return Error{{}, "only what is loose can be attached"};
  return {};
}

}  // namespace

Result<void> attach(World& world, ModelId child, ModelId parent, const geom::Pose& X_PC) {
  const AttachedChild attachment{child, X_PC};
  return attach(world, std::span(&attachment, 1), parent);
}

Result<void> attach(World& world, std::span<const AttachedChild> children, ModelId parent) {
  const ModelRow parent_row = world.row(parent);
  if (!parent_row) return no_model();
  std::vector<ModelId> named;
  for (const AttachedChild& each : children) named.push_back(each.child);
  if (is_any_named_twice(std::move(named))) return named_twice();
  for (const AttachedChild& each : children)
    if (const Result<void> checked = check_attachment(world, each, parent_row); !checked) return checked;
  if (children.empty()) return {};
  Models& models = world.models;
  const Mobility parents = models.mobility[parent_row];
  const auto set_parents = [&](ModelId to) {
    for (const AttachedChild& each : children) models.parent_id[world.row(each.child)] = to;
  };
  set_parents(parent);
  Population population(world);
  if (!population.derive()) {
    set_parents({});
    population.derive();
    return Error{{}, "too many models would be attached to each other"};
  }
  for (const auto& [child, X_PC] : children) {
    const ModelRow row = world.row(child);
    models.X_PM.own(row) = {X_PC.x, X_PC.y, X_PC.z, geom::normalize(X_PC.a)};
    models.tilt_PM.set(row, {});
    place_tree(world, row);
    models.V_WM.set(row, {});
    world.events.add({Event::EventKind::kAttach, child, parent, 0, std::min(Mobility::kLoose, parents)});
  }
  wake(models);
  return {};
}

Result<void> detach(World& world, ModelId child) {
  return detach(world, std::span(&child, 1));
}

Result<void> detach(World& world, std::span<const ModelId> children) {
  if (is_any_named_twice({children.begin(), children.end()})) return named_twice();
  for (const ModelId child : children) {
    const ModelRow row = world.row(child);
    if (!row) return no_model();
    if (!was_attached(world, row)) return Error{{}, "it is not attached to anything"};
  }
  if (children.empty()) return {};
  Models& models = world.models;
  std::vector<ModelId> parents;
  std::vector<Mobility> mobility;  // of the parents, which may be detached as well
  for (const ModelId child : children) {
    const ModelRow row = world.row(child);
    parents.push_back(models.parent_id[row]);
    mobility.push_back(models.mobility[models.parent[row]]);
    models.parent_id[row] = {};
    models.X_PM.own(row) = models.X_WM[row];
    models.tilt_PM.set(row, models.tilt_WM[row]);
  }
  Population population(world);
  const bool derived = population.derive();
  PLAYHOUSE_ASSERT(derived);
  for (std::size_t i = 0; i < children.size(); ++i) {
    const ModelRow row = world.row(children[i]), parent = world.row(parents[i]);
    models.V_WM.set(row, {});
    const Mobility least = std::min({mobility[i], models.mobility[parent], models.mobility[row]});
    world.events.add({Event::EventKind::kDetach, children[i], parents[i], 0, least});
  }
  wake(models);
  return {};
}

std::vector<ModelId> attached_models(const World& world) {
  std::vector<ModelId> attached;
  for (const ModelRow row : world.models.rows())
    if (was_attached(world, row)) attached.push_back(world.models.id[row]);
  return attached;
}

}  // namespace playhouse::world
