#pragma once

/// ArenaEngine: bodies with mass, which fall, slide, push and are pushed, and robots on wheels. Rangers and
/// cameras see them in space (lidar_sense.h, camera_sense.h), other senses as those of the stage engine do:
/// extruded outlines, at heights. Thread: the tick thread.

#include <vector>

#include "playhouse/arena/body_plan.h"
#include "playhouse/arena/mesh_solids.h"
#include "playhouse/arena/physics.h"
#include "playhouse/stage/body_engine.h"

namespace playhouse::arena {

class ArenaEngine final : public stage::BodyEngine {
 public:
  ArenaEngine(const scene::SceneDesc& scene, std::uint64_t seed, unsigned workers, const Surface& ground);

 private:
  /// A tree of models as a body.
  struct Body {
    static constexpr std::uint32_t kNone = world::ModelRow::kNone;
    Part part = Part::kGuided;
    std::uint32_t number = kNone;       // of Physics; none: it is no obstacle
    double radius = 0;                  // m, of what it is driven about
    bool has_joints = false;            // parts of it move by themselves
    std::vector<geom::Pose> joints;     // X_PM of those parts as Physics has them
    std::vector<std::uint32_t> models;  // (hulls) rows of whose each is
  };

  void move() override;
  /// The hulls that Physics has, without the margin by which Bullet rounds them.
  world::PhysicsShapes shapes() const override;
  void populated(bool fixed) override;
  void replaced(std::uint32_t) override {}

  Body make_body(std::uint32_t tree);
  std::span<const stage::Mover> movers_of(std::uint32_t tree) const;
  /// Parts of the tree that move by themselves; the top is one where nothing pushes it.
  std::span<const stage::Mover> parts_of(std::uint32_t tree) const;
  void load(std::uint32_t tree);
  void load_guided(std::uint32_t tree);
  void bend(std::uint32_t tree);
  void find_blocked(unsigned steps);
  geom::Vec3 way_of(const geom::Vec3& p, const stage::Mover& mover) const;
  bool is_blocked(const stage::Mover& mover) const { return blocked_[&mover - trees_.movers.data()] != 0; }
  void store(std::uint32_t tree);
  bool store_state(std::uint32_t tree);
  void store_drive(std::uint32_t tree, const geom::Pose& before);
  bool store_parts(std::uint32_t tree);
  bool is_driven(std::uint32_t tree) const;

  Physics physics_;
  mutable MeshHulls mesh_hulls_;
  std::vector<Body> bodies_;            // (trees)
  std::vector<std::uint32_t> tree_of_;  // (bodies of Physics)
  bool has_parts_ = false;              // something moves by itself, see parts_of()
  std::vector<std::uint8_t> blocked_;   // (trees_.movers) in this tick
};

}  // namespace playhouse::arena
