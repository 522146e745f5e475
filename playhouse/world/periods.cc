#include "playhouse/world/periods.h"

#include <cmath>

namespace playhouse::world {

std::uint64_t ticks_of(double seconds, double interval) {
  constexpr double kRounding = 1e-6, kMost = 1e15;
  const double ticks = std::ceil(seconds / interval - kRounding);
  return ticks < 1 ? 1 : static_cast<std::uint64_t>(ticks > kMost ? kMost : ticks);
}

std::uint64_t update_ticks(const World& world, ModelRow model) {
  return ticks_of(world.desc(model).update_interval, world.scene().interval);
}

}  // namespace playhouse::world
