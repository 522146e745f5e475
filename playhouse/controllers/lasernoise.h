#pragma once

/// lasernoise: adds proportional noise to the ranges of its ranger. See docs/controllers.md.

#include "playhouse/base/rng.h"
#include "playhouse/controllers/batch.h"

namespace playhouse::controllers {

class LaserNoise final : public BatchOf<LaserNoise> {
 public:
  LaserNoise() : BatchOf("lasernoise") {}

  void decide(world::World&, std::size_t, std::size_t) override {}
  bool filters() const override { return true; }
  void filter(world::World& world, std::size_t begin, std::size_t end) override;

 private:
  friend BatchOf<LaserNoise>;
  static auto memory(auto&) { return std::tuple<>(); }
  /// Does not subscribe: applies only to measurements made for others.
  Result<void> join(world::World& world, const Post& post) override;
  void leave_rest(std::size_t i) { erase_at(i, ranger_, stream_); }
  void resolve(const world::World& world, std::size_t i) override;

  std::vector<world::RangerRow> ranger_;
  std::vector<Stream> stream_;
};

}  // namespace playhouse::controllers
