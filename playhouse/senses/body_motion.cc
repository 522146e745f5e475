#include "playhouse/senses/body_motion.h"

namespace playhouse::senses {

using geom::Vec3;

Vec3 velocity_at(const world::World& world, world::ModelRow root, const Vec3& p) {
  const geom::Pose& X = world.models.X_WM[root];
  const Vec3 arm = p - Vec3{X.x, X.y, X.z};
  const geom::SpatialVelocity& V = world.models.V_WM[root];
  if (!world.upright || world.models.kind[root] != scene::ModelKind::kPosition) return V.v + cross(V.w, arm);
  if (world.positions.stall[world.models.part[root]]) return {};
  const geom::Twist& driven = world.positions.velocity[world.models.part[root]];
  const geom::Vec2 v = geom::Rotation::of(X.a) * geom::Vec2{driven.x, driven.y};
  return Vec3{v.x, v.y, driven.z} + cross(Vec3{0, 0, driven.a}, arm);
}

}  // namespace playhouse::senses
