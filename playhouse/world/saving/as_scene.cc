#include "playhouse/world/saving/as_scene.h"

#include <fmt/format.h>

#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "playhouse/scene/generated/bodies.h"
#include "playhouse/scene/write_world.h"
#include "playhouse/world/population/population.h"
#include "playhouse/world/population/rows.h"

namespace playhouse::world {
namespace {

constexpr double kUpright = 0.01;   // rad; contacts tilt resting bodies by less
constexpr double kRounding = 1e-9;  // rad

bool are_near(geom::Tilt a, geom::Tilt b, double tolerance) {
  return std::fabs(a.x - b.x) <= tolerance && std::fabs(a.y - b.y) <= tolerance;
}

/// A pose as a file says it.
struct SaidPose {
  geom::Pose X_PM;
  double roll = 0, pitch = 0;  // rad
};

SaidPose said_in(const World& world, ModelRow row) {
  const scene::ModelDesc& desc = world.desc(row);
  if (world.upright) return {pose_said(world, row), desc.roll, desc.pitch};
  const auto [X, tilt] = desc.kind == scene::ModelKind::kActuator ? joint_of(world, world.models.part[row])
                                                                  : pose_in_parent(world.models, row);
  const geom::SpatialPose start = tilted(desc, desc.X_PM);
  if (are_near(tilt, start.tilt, kRounding)) {
    const double yaw = X.a == start.X.a ? desc.X_PM.a : geom::normalize(X.a - start.X.a + desc.X_PM.a);
    return {{X.x, X.y, X.z, yaw}, desc.roll, desc.pitch};
  }
  if (are_near(tilt, {}, kUpright)) return {X};
  const geom::RollPitchYaw turns = geom::roll_pitch_yaw(X.a, tilt);
  return {{X.x, X.y, X.z, turns.yaw}, turns.roll, turns.pitch};
}

bool is_tilted_as_described(const SaidPose& said, const scene::ModelDesc& desc) {
  return said.roll == desc.roll && said.pitch == desc.pitch;
}

class StandingScene {
 public:
  explicit StandingScene(const World& world) : world_(world), from_(world.scene()) {}

  scene::SceneDesc make();

 private:
  /// Difference of a tree from its prototype beyond per-tree values.
  enum class Change : std::uint8_t {
    kNone,
    kTop,    // its root differs, or has attached models
    kParts,  // a part differs
  };

  void find_attached();
  void add_tree(ModelRow row);
  Change change_of(ModelRow row, std::uint32_t size) const;
  bool is_another(ModelRow row) const;
  /// The pose for the file: an actuator's is that at position 0.
  /// Models spawned at run time have no controllers, whatever their prototype has.
  bool came(ModelRow top) const { return Population::given(world_).contains(world_.models.id[top]); }
  /// Appends descriptions of a model's present state, with its parts.
  void describe(ModelRow row, std::int32_t parent, std::string alias, bool came);
  void describe_children(ModelRow row, std::uint32_t desc, bool came);
  /// The default name of another child of its type.
  using Siblings = std::map<std::string_view, int>;
  std::string unsaid_name(ModelRow row, std::string_view before, Siblings& siblings) const;
  void note_renamed(ModelRow row, std::uint32_t size);

  const World& world_;
  const scene::SceneDesc& from_;
  scene::SceneDesc scene_;
  std::map<ModelRow, std::vector<ModelRow>> attached_;  // rows, by row of the parent
  Siblings tops_{{"model", 1}};                         // counted as in files
};

scene::SceneDesc StandingScene::make() {
  scene_ = from_;
  scene_.trees.clear();
  scene_.renamed.clear();
  scene_.warnings.clear();
  find_attached();
  for (const ModelRow row : world_.models.rows())
    if (!world_.models.parent[row]) add_tree(row);
  if (scene_.trees.empty()) scene_.models.clear();  // an empty list of trees would instantiate each prototype
  return std::move(scene_);
}

void StandingScene::find_attached() {
  for (const ModelRow row : world_.models.rows()) {
    const ModelRow parent = world_.models.parent[row];
    if (parent && world_.desc(row).parent < 0) attached_[parent].push_back(row);
  }
}

void StandingScene::add_tree(ModelRow row) {
  const std::uint32_t top = world_.models.desc[row], size = scene::tree_size(from_, top);
  scene::TreeDesc tree{top,
                       world_.name(row),
                       unsaid_name(row, {}, tops_),
                       world_.where(row),
                       said_in(world_, row).X_PM,
                       world_.models.color[row],
                       world_.models.fiducial_return[row]};
  const Change change = change_of(row, size);
  if (change == Change::kNone) {
    note_renamed(row, size);
  } else {
    tree.top = static_cast<std::uint32_t>(scene_.models.size());
    describe(row, -1, tree.alias, came(row));
    if (change == Change::kParts) scene_.models[tree.top].prototype = tree.name;
  }
  scene_.trees.push_back(std::move(tree));
}

StandingScene::Change StandingScene::change_of(ModelRow row, std::uint32_t size) const {
  const bool is_new = came(row);
  const auto says_otherwise = [&](ModelRow model) {
    const scene::ModelDesc& desc = world_.desc(model);
    return world_.models.say[model] != desc.say || (is_new && !desc.ctrl.empty()) ||
           !is_tilted_as_described(said_in(world_, model), desc) || say_rows(world_, model);
  };
  // A tree's own models are consecutive rows.
  for (const ModelRow part : RowsOf(row + 1, row + size))
    if (says_otherwise(part) || is_another(part) || attached_.contains(part)) return Change::kParts;
  return says_otherwise(row) || attached_.contains(row) ? Change::kTop : Change::kNone;
}

bool StandingScene::is_another(ModelRow row) const {
  const Models& models = world_.models;
  const scene::ModelDesc& desc = world_.desc(row);
  return said_in(world_, row).X_PM != desc.X_PM || models.color[row] != desc.color ||
         models.fiducial_return[row] != desc.fiducial_return;
}

std::string StandingScene::unsaid_name(ModelRow row, std::string_view before, Siblings& siblings) const {
  const std::string& type = world_.desc(row).type;
  return std::string(before) + type + ":" + std::to_string(siblings[type]++);
}

void StandingScene::describe(ModelRow row, std::int32_t parent, std::string alias, bool came) {
  scene::ModelDesc desc = world_.desc(row);
  const bool is_attached = parent >= 0 && desc.parent < 0;
  desc.name = world_.name(row);
  desc.alias = std::move(alias);
  desc.parent = parent;
  const SaidPose said = said_in(world_, row);
  desc.X_PM = said.X_PM;
  desc.roll = said.roll;
  desc.pitch = said.pitch;
  desc.color = world_.models.color[row];
  desc.fiducial_return = world_.models.fiducial_return[row];
  desc.say = world_.models.say[row];
  if (came) desc.ctrl.clear();
  if (say_rows(world_, row, &desc) && desc.moving_blocks > 0) {  // also changes its kind's body
    desc.blocks.clear();
    scene::make_body(*scene::body_size(desc.size), desc);
  }
  if (is_attached) {
    const scene::ModelDesc& below = scene_.models[static_cast<std::size_t>(parent)];
    desc.stacked = below.stacks_children ? below.size.z : 0;
  }
  const auto made = static_cast<std::uint32_t>(scene_.models.size());
  scene_.models.push_back(std::move(desc));
  describe_children(row, made, came);
}

void StandingScene::describe_children(ModelRow row, std::uint32_t desc, bool came) {
  const std::string before = scene_.models[desc].name + ".";
  Siblings siblings;
  const auto describe_one = [&](ModelRow child, bool child_came) {
    describe(child, static_cast<std::int32_t>(desc), unsaid_name(child, before, siblings), child_came);
  };
  for (const ModelRow child : world_.children(row))
    if (world_.desc(child).parent >= 0) describe_one(child, came);
  if (const auto attached = attached_.find(row); attached != attached_.end())
    for (const ModelRow child : attached->second) describe_one(child, this->came(child));
}

/// Records renamed parts of the next tree.
void StandingScene::note_renamed(ModelRow row, std::uint32_t size) {
  if (from_.renamed.empty()) return;
  const auto tree = static_cast<std::uint32_t>(scene_.trees.size());
  const std::string top = world_.name(row);
  const std::string& prototype = world_.desc(row).name;
  for (std::uint32_t place = 1; place < size; ++place) {
    const scene::ModelDesc& part = world_.desc(row + place);
    std::string name = world_.name(row + place), alias = world_.alias(row + place);
    if (name == scene::token_in(part.name, prototype, top) &&
        alias == scene::token_in(part.alias, prototype, top))
      continue;
    scene_.renamed[{tree, place}] = {std::move(name), std::move(alias)};
  }
}

}  // namespace

scene::SceneDesc as_scene(const World& world) {
  return StandingScene(world).make();
}

Result<std::string> world_file(const scene::SceneDesc& standing, double time, const std::string& path) {
  Result<std::string> text = scene::write_world(standing, path);
  if (!text) return text.error();
  return fmt::format("# As it stood at {} s of a run, saved by Playhouse.\n", time) + *text;
}

}  // namespace playhouse::world
