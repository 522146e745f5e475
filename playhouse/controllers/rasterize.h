#pragma once

/// rasterize: logs a raster of its model's body once. For models of any kind.

#include <string>

#include "playhouse/controllers/batch.h"

namespace playhouse::controllers {

/// Raster of a body's outline in its model's box, from above: a line for each
/// row of cells, from the largest y, "O" on the outline and "." elsewhere.
std::vector<std::string> raster_of(const scene::ModelDesc& desc, int columns, int rows);

class Rasterize final : public BatchOf<Rasterize> {
 public:
  Rasterize() : BatchOf("rasterize") {}

  void decide(world::World&, std::size_t, std::size_t) override {}
  void deliver(world::World& world) override;

 private:
  friend BatchOf<Rasterize>;
  static auto memory(auto& self) { return std::tie(self.done_); }
  Result<void> join(world::World&, const Post&) override { return done_.push_back(0), Result<void>(); }
  void leave_rest(std::size_t) {}
  void resolve(const world::World&, std::size_t) override {}

  // Memory.
  std::vector<std::uint8_t> done_;  // already logged
};

}  // namespace playhouse::controllers
