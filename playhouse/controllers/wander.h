#pragma once

/// wander, and wander_accel, an alias: drives ahead and avoids
/// obstacles by a scanner. Constants of Stage; see docs/controllers.md.

#include "playhouse/controllers/steering.h"

namespace playhouse::controllers {

class Wander final : public BatchOf<Wander> {
 public:
  explicit Wander(std::string name) : BatchOf(std::move(name)) {}

  void decide(world::World& world, std::size_t begin, std::size_t end) override {
    for (std::size_t i = begin; i < end; ++i)
      if (steering_.is_new_scan(world, i)) steering_.steer(world, i);
  }

 private:
  friend BatchOf<Wander>;
  static auto memory(auto& self) { return Steering::memory(self.steering_); }
  Result<void> join(world::World& world, const Post& post) override { return steering_.join(world, post); }
  void leave_rest(std::size_t i) { steering_.leave_rest(i); }
  void resolve(const world::World& world, std::size_t i) override {
    steering_.resolve(world, world.row(id(i)), i);
  }

  Steering steering_;
};

}  // namespace playhouse::controllers
