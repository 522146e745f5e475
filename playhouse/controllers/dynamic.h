#pragma once

/// dynamic: spawns a hundred small parts and attaches them to its model. For models of any kind.

#include "playhouse/base/rng.h"
#include "playhouse/controllers/batch.h"

namespace playhouse::controllers {

class Dynamic final : public BatchOf<Dynamic> {
 public:
  Dynamic() : BatchOf("dynamic") {}

  /// Adds a description of the parts to a scene in which a model runs this controller:
  /// only described models can be spawned. Before a world is made from it.
  static void describe_parts(scene::SceneDesc& scene);

  void decide(world::World&, std::size_t, std::size_t) override {}
  /// Spawns the parts in the first tick.
  void deliver(world::World& world) override;

 private:
  friend BatchOf<Dynamic>;
  static auto memory(auto& self) { return std::tie(self.done_); }
  /// Fails if the scene does not describe the parts.
  Result<void> join(world::World& world, const Post& post) override;
  void leave_rest(std::size_t i) { erase_at(i, model_, stream_); }
  void resolve(const world::World& world, std::size_t i) override { model_[i] = world.row(id(i)); }
  Result<void> add_part(world::World& world, std::size_t i, Rng& random) const;

  std::uint32_t part_ = 0;  // row of SceneDesc::models
  std::vector<world::ModelRow> model_;
  std::vector<Stream> stream_;

  // Memory.
  std::vector<std::uint8_t> done_;  // parts were spawned
};

}  // namespace playhouse::controllers
