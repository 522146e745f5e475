#include "playhouse/drivers/interfaces/shapes.h"

namespace playhouse::drivers {

geom::SpatialPose pose_on_robot(const world::World& world, world::ModelRow model) {
  geom::SpatialPose X{world.desc(model).X_MB, {}};
  const std::uint32_t root = world.models.root[model.index];
  if (root == model.index) return geom::compose(world::pose_in_world(world.models, {root}), X);
  for (std::uint32_t row = model.index; row != root; row = world.models.parent[row]) {
    X = geom::compose(world::pose_in_parent(world.models, {row}), X);
  }
  return X;
}

}  // namespace playhouse::drivers
