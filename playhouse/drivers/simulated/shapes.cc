#include "playhouse/drivers/simulated/shapes.h"

namespace playhouse::drivers {

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
