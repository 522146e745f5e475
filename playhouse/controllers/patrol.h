#pragma once

/// patrol: walks from waypoint to waypoint, and from the last to the first again; for people, carts and other
/// obstacles that move. It senses nothing: whatever is in the way stops it until it is gone.

#include "playhouse/controllers/batch.h"

namespace playhouse::controllers {

class Patrol final : public BatchOf<Patrol> {
 public:
  Patrol() : BatchOf("patrol") {}

  void decide(world::World& world, std::size_t begin, std::size_t end) override;

 private:
  friend BatchOf<Patrol>;
  static auto memory(auto& self) { return std::tie(self.next_); }
  /// Arguments: [SPEED] X Y [X Y ...], in metres and metres per second; an odd count has the speed.
  Result<void> join(world::World& world, const Post& post) override;
  void leave_rest(std::size_t i) { erase_at(i, robot_, speed_, waypoints_); }
  void resolve(const world::World& world, std::size_t i) override;

  std::vector<world::PositionRow> robot_;
  std::vector<double> speed_;                       // m/s
  std::vector<std::vector<geom::Vec2>> waypoints_;  // in the world [m], at least one

  // Memory.
  std::vector<std::uint32_t> next_;  // waypoint
};

}  // namespace playhouse::controllers
