#pragma once

/// diffusion: robots with a ring of short-range proximity sensors drive straight and
/// turn away from obstacles. Rule and constants of the diffusion example of ARGoS
/// (Pinciroli et al., Swarm Intelligence 6:271-295, 2012); see docs/controllers.md.

#include <map>
#include <utility>

#include "playhouse/controllers/batch.h"

namespace playhouse::controllers {

class Diffusion final : public BatchOf<Diffusion> {
 public:
  explicit Diffusion(std::string name) : BatchOf(std::move(name)) {}

  void decide(world::World& world, std::size_t begin, std::size_t end) override;

 private:
  friend BatchOf<Diffusion>;
  static auto memory(auto& self) { return std::tie(self.seen_); }
  /// Uses the ranger with the most sensors.
  Result<void> join(world::World& world, const Post& post) override;
  void leave_rest(std::size_t i) { erase_at(i, robot_, ranger_, first_beam_, ring_); }
  void resolve(const world::World& world, std::size_t i) override;
  void find_rows(const world::World& world, world::ModelRow model, std::size_t i);

  /// A beam of a ring: its direction in the robot's frame,
  /// and the ranges of full and of no activation. [m]
  struct RingBeam {
    double x = 0, y = 0;
    float touches = 0, unnoticed = 0;
    auto operator<=>(const RingBeam&) const = default;
  };
  using DiffusionRing = std::vector<RingBeam>;  // shared by robots with equal rings
  static DiffusionRing ring_of(const world::World& world, world::ModelRow robot, world::RangerRow ranger);

  std::vector<DiffusionRing> rings_;
  std::map<DiffusionRing, std::uint32_t> place_of_ring_;
  std::vector<std::uint32_t> ring_;  // by robot

  // Rows of a robot and of its ring.
  std::vector<world::PositionRow> robot_;
  std::vector<world::RangerRow> ranger_;
  std::vector<world::BeamRow> first_beam_;

  // Memory.
  std::vector<std::uint64_t> seen_;  // tick of the last scan acted on
};

}  // namespace playhouse::controllers
