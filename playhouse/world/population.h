#pragma once

/// Population: models that come, go, and become parts of each other between ticks. Every function checks what
/// it is asked, does all of it or nothing, and leaves an entry in world.changes. Rows move; ids do not.
/// Thread: the tick thread, between steps, or a phase that runs alone.

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "playhouse/base/result.h"
#include "playhouse/world/world.h"

namespace playhouse::world {

/// A new tree of the prototype whose top is at this row of SceneDesc::models, at X_WM. An empty name stands
/// for that of the prototype's first tree with the least number behind it that makes it new ("r0~2"). Its
/// sensors measure and its wheels turn once somebody subscribes, as with any model. Gives the id of the top;
/// ids of the rest follow it. Cost: the size of the tree. Fails on a prototype that is none, a pose that is
/// no place, a name that is taken, and where the world has no room (base/limits.h).
Result<ModelId> spawn(World& world, std::uint32_t prototype, const geom::Pose& X_WM, std::string name = {});

/// A name like this one that nobody has: with the least number behind it, in place of the one that it may
/// have ("r0~3" for "r0~2").
std::string fresh_name(const World& world, std::string_view like);

/// Another tree like the one that a model is in, with the color and mark that its top has now; at X_WM, but
/// as high as that. An empty name stands for a fresh one. Gives and fails as spawn().
Result<ModelId> spawn_like(World& world, ModelRow model, geom::Pose X_WM, std::string name = {});

/// Takes a top-level model and all its own parts out of the world; what was attached to it stays where it
/// is. Cost: the population. Fails if there is no such model or it is a part.
Result<void> despawn(World& world, ModelId model);
/// The same for several, in their order and at the cost of one. Fails, and all stay, where one of them is
/// none, is a part, or is named twice.
Result<void> despawn(World& world, std::span<const ModelId> models);

/// Makes a top-level model a part of another tree, at X_PC in `parent` and upright in that. Fails where the
/// parent is in the child's own tree, something in that drives or the child is fixed, or either does not
/// exist.
Result<void> attach(World& world, ModelId child, ModelId parent, const geom::Pose& X_PC);

/// Makes a model that was attached a top-level one again, where it is now. Fails for any other.
Result<void> detach(World& world, ModelId child);

/// How rows come and go, for spawn() and its like and for a world that is loaded.
class Population {
 public:
  explicit Population(World& world) : world_(world) {}

  /// Fails where models of these rows of SceneDesc::models would be too many with those there are, or have
  /// too many sensors, beams or corners (base/limits.h).
  Result<void> check_room(std::span<const std::uint32_t> descs) const;
  /// Room for the models of these trees, and what all columns share of the prototypes. Before any row.
  void begin(std::span<const scene::TreeDesc> trees);
  /// Removes every model.
  void clear();
  /// A row at the end of every table that its kind has, as it is at the start of its life. `X_PM` is where
  /// the scene, or who spawned it, puts it. Derived columns are complete if `parent` is a row that exists.
  ModelRow append(ModelId id, std::uint32_t desc, ModelRow parent, const geom::Pose& X_PM);
  /// Rows for the `count` models of the prototype whose top is at `desc`, with the next ids from `top` on.
  void append_tree(ModelId top, std::uint32_t desc, std::uint32_t count, const geom::Pose& X_WM);
  struct Rows {
    std::uint32_t begin = 0, end = 0;
  };
  /// Removes runs of rows of the models, ascending, and what they have in other tables. derive() is due then.
  void erase(std::span<const Rows> runs);
  /// Computes every derived column again but poses and subscribers. False, and no use of the world, if the
  /// population columns make no trees, or deeper ones than limits::kTreeDepth.
  bool derive();

  using Given = World::Given;
  std::uint32_t& next_id() { return world_.next_id_; }
  Serials& serials() { return world_.serials_; }
  std::uint64_t& seed() { return world_.seed_; }
  std::map<ModelId, Given>& given() { return world_.given_; }
  static std::uint32_t next_id(const World& world) { return world.next_id_; }
  static const Serials& serials(const World& world) { return world.serials_; }
  static const std::map<ModelId, Given>& given(const World& world) { return world.given_; }
  /// Completes what append() leaves open for the models from row `first` on.
  void settle(std::uint32_t first);
  /// Lets World::find() know the names of the models from row `first` on, which were given already.
  void add_names(std::uint32_t first);
  /// Where the scene, or who spawned it, put a model in its parent.
  geom::Pose start_of(ModelRow row) const;

 private:
  void add_part(ModelRow row);
  /// Puts the rows from `first` on behind the children of their parents.
  void link(std::uint32_t first);
  void note_change(std::uint32_t first);
  bool derive_trees();
  void derive_parts();
  void derive_mobility(std::uint32_t first);

  World& world_;
};

}  // namespace playhouse::world
