#include "playhouse/bridge/interfaces/pose_on_robot.h"

namespace playhouse::drivers {

geom::SpatialPose pose_on_robot(const world::World& world, world::ModelRow model) {
  geom::SpatialPose X{world.desc(model).X_MB, {}};
  const world::ModelRow root = world.models.root[model];
  if (root == model) return geom::compose(world::pose_in_world(world.models, root), X);
  for (world::ModelRow row = model; row != root; row = world.models.parent[row]) {
    X = geom::compose(world::pose_in_parent(world.models, row), X);
  }
  return X;
}

}  // namespace playhouse::drivers
