#pragma once

/// Population: spawning, removing, attaching and detaching of models between ticks. Every
/// function validates its arguments, is atomic, and adds an entry to world.events. Rows change;
/// ids do not. Thread: the tick thread, between steps, or a phase that runs sequentially.

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "playhouse/base/result.h"
#include "playhouse/world/world.h"

namespace playhouse::world {

/// Spawns a tree of the prototype whose root is at this row of SceneDesc::models, at X_WM. An
/// empty name becomes that of the prototype's first tree plus the smallest number that makes
/// it unique ("r0~2"). Sensors and motors work once subscribed, as with any model. Returns
/// the id of the root; the ids of its parts follow. Cost: the size of the tree. Fails on an
/// invalid prototype, an invalid pose, a name in use, and at capacity (base/limits.h).
Result<ModelId> spawn(World& world, std::uint32_t prototype, const geom::Pose& X_WM, std::string name = {});

/// For a spawn that a peer asks for, before it: fails if the models that came during the run are as many as
/// peers may bring in all (base/limits.h, kBrought...).
Result<void> check_budget(const World& world);

/// A unique name derived from this one: with the smallest free number
/// appended, replacing the number that it may have ("r0~3" for "r0~2").
std::string fresh_name(const World& world, std::string_view like);

/// Spawns a copy of the tree that a model is in, with its root's present colour and fiducial, at
/// X_WM but at the root's height. An empty name becomes a fresh one. Returns and fails as spawn().
Result<ModelId> spawn_like(World& world, ModelRow model, geom::Pose X_WM, std::string name = {});

/// Removes a root and all its own parts; models attached to it stay in place.
/// Cost: the population. Fails if the model does not exist or is a part.
Result<void> despawn(World& world, ModelId model);
/// Removes several at the cost of one, in order. Atomic: fails
/// if one does not exist, is a part, or is listed twice.
Result<void> despawn(World& world, std::span<const ModelId> models);

/// The pose of a model that is described with this roll and pitch and begins at X_PM, whose heading is the
/// yaw.
geom::SpatialPose tilted(const scene::ModelDesc& desc, const geom::Pose& X_PM);

/// For what tilts models, before the first tick: each model is turned by the roll and pitch of its
/// description, as are those that come later.
void tilt_as_described(World& world);

/// Attaches a root to another tree, at X_PC in `parent`, upright in it. Fails if the parent is
/// in the child's tree, if the child is fixed or has a driven part, or if either does not exist.
Result<void> attach(World& world, ModelId child, ModelId parent, const geom::Pose& X_PC);

/// Attaches several to one parent, at their poses in it, at the cost of one. Atomic. Fails as attach(), and
/// if one is named twice.
struct AttachedChild {
  ModelId child;
  geom::Pose X_PC;
};
Result<void> attach(World& world, std::span<const AttachedChild> children, ModelId parent);

/// Detaches an attached model: it becomes a root at its present pose. Fails for any other model.
Result<void> detach(World& world, ModelId child);
/// Detaches several at the cost of one. Atomic. Fails as detach(), and if one is named twice.
Result<void> detach(World& world, std::span<const ModelId> children);

/// All attached models, ascending.
std::vector<ModelId> attached_models(const World& world);

/// Insertion and removal of rows, for spawn() and others and for loading a state.
class Population {
 public:
  explicit Population(World& world) : world_(world) {}

  /// Fails if models of these rows of SceneDesc::models, added to the present
  /// ones, exceed limits on models, sensors, beams or corners (base/limits.h).
  Result<void> check_room(std::span<const std::uint32_t> descs) const;
  /// Reserves room for the models of these trees; sets prototype values of shared columns. Before any row.
  void begin(std::span<const scene::TreeDesc> trees);
  /// Removes every model.
  void clear();
  /// Appends a row to every table of its kind, in its initial state. `X_PM` is the pose given
  /// by the scene or by the spawn. Derived columns are complete if `parent` is an existing row.
  ModelRow append(ModelId id, std::uint32_t desc, ModelRow parent, const geom::Pose& X_PM);
  /// Appends the `count` models of the prototype whose root is at `desc`, with consecutive ids from `top` on.
  void append_tree(ModelId top, std::uint32_t desc, std::uint32_t count, const geom::Pose& X_WM);
  /// Removes ascending runs of model rows and their rows in other tables. Call derive() afterwards.
  void erase(std::span<const RowsOf<ModelTable>> runs);
  /// Recomputes all derived columns except poses and subscribers. False, and the world is unusable,
  /// if the population columns do not form trees, or ones deeper than limits::kTreeDepth.
  bool derive();

  using Given = World::Given;
  std::uint32_t& next_id() { return world_.next_id_; }
  Serials& serials() { return world_.serials_; }
  std::uint64_t& seed() { return world_.seed_; }
  std::map<ModelId, Given>& given() { return world_.given_; }
  static std::uint32_t next_id(const World& world) { return world.next_id_; }
  /// The least id of a model that comes during the run.
  static ModelId first_of_run(const World& world) { return {world.first_id_.back()}; }
  static const Serials& serials(const World& world) { return world.serials_; }
  static const std::map<ModelId, Given>& given(const World& world) { return world.given_; }
  /// Completes what append() defers, for the models from row `first` on.
  void settle(ModelRow first);
  /// Adds the names of the models from row `first` on to the index of World::find().
  void add_names(ModelRow first);
  /// The initial pose of a model in its parent, from the scene or the spawn.
  geom::Pose start_of(ModelRow row) const;

 private:
  void add_part(ModelRow row);
  /// Appends the rows from `first` on to the child lists of their parents.
  void link(ModelRow first);
  void note_change(ModelRow first);
  bool derive_trees();
  void derive_parts();
  void derive_mobility(ModelRow first);

  World& world_;
};

}  // namespace playhouse::world
