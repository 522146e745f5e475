#include "playhouse/drivers/simulated/shapes.h"

#include <algorithm>
#include <cmath>

namespace playhouse::drivers {

std::uint64_t update_ticks(const world::World& world, world::ModelRow model) {
  const double ticks = std::ceil(world.desc(model).update_interval / world.scene().interval - 1e-9);
  return ticks >= 1 && ticks < 1e15 ? static_cast<std::uint64_t>(ticks) : 1;
}

geom::Pose pose_on_robot(const world::World& world, world::ModelRow model) {
  geom::Pose X = world.desc(model).X_MB;
  const std::uint32_t root = world.models.root[model.index];
  if (root == model.index) return geom::compose(world.models.X_WM[root], X);
  for (std::uint32_t row = model.index; row != root; row = world.models.parent[row]) {
    X = geom::compose(world.models.X_PM[row], X);
  }
  return X;
}

}  // namespace playhouse::drivers
