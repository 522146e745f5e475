#pragma once

/// OverlapWarnings: a line in the log when a client puts a model into another one. It is put there
/// all the same: what is carried, or moved again before the next tick, may overlap for a while.

#include <string_view>

#include "playhouse/world/world.h"

namespace playhouse::drivers {

class OverlapWarnings {
 public:
  /// Tick thread. `done`: "spawned", "moved". Tells limits::kWarningsOfAKind times at most.
  void placed(const world::World& world, world::ModelRow model, std::string_view done);

 private:
  std::size_t told_ = 0;
};

}  // namespace playhouse::drivers
