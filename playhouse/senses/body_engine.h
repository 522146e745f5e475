#pragma once

/// BodyEngine: what engines share whose models are the extruded solids of bodies.h: their
/// tables, kept up to date as models are spawned and removed, and the senses that measure
/// among them. A derived engine adds how trees of models move. Thread: the tick thread.

#include <optional>
#include <vector>

#include "playhouse/behaviour/phased_engine.h"
#include "playhouse/senses/generated/senses.h"

namespace playhouse::senses {

class BodyEngine : public behaviour::PhasedEngine {
 public:
  std::uint64_t rays() const override { return rays_; }

 protected:
  /// The outlines of obstacles as prisms.
  world::PhysicsShapes shapes() const override;
  /// Derived engines call populate() in their constructors.
  BodyEngine(const scene::SceneDesc& scene, std::uint64_t seed, unsigned workers,
             const SenseMakers& makers = {});

  /// trees_, solids_ and index_ were rebuilt; their static part only if `fixed`.
  virtual void populated(bool fixed) = 0;
  /// A tree was teleported: its solids have new places that move() did not make.
  virtual void replaced(bodies::TreeRow tree) = 0;

  /// Rebuilds all tables from the population; those of static solids only if they differ.
  void populate();
  /// Rebuilds index_. To be called after solids have moved.
  void index();

  bodies::Shapes shapes_;
  bodies::Trees trees_;
  bodies::Solids solids_;
  bodies::DiscIndex index_;  // the movable solids
  bodies::Walls walls_;

 private:
  void ingest(std::span<const world::Event> events) override;
  void sense(std::uint64_t tick) override;
  void touching(world::ModelRow model, const world::ByModel<std::uint8_t>& wanted,
                std::vector<world::ModelRow>& out) const override;
  bool have_static_models_changed();
  bool moves_within_body(const world::Event& event) const;
  void replace(const world::Event& event);
  bodies::Space space() const { return {solids_, index_, walls_}; }

  std::optional<std::vector<bodies::StaticModel>> static_models_;  // that solids_ has
  Senses senses_;
  std::uint64_t rays_ = 0;
};

}  // namespace playhouse::senses
