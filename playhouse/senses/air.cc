#include "playhouse/senses/air.h"

#include <algorithm>
#include <cmath>

#include "playhouse/senses/body_motion.h"

namespace playhouse::senses {
namespace {

geom::Vec3 middle_of(const world::World& world, world::ModelRow model) {
  const geom::Pose up{0, 0, world.desc(model).size.z / 2, 0};
  const geom::Pose X = geom::compose(body_pose(world, model), {up, geom::Tilt{}}).X;
  return {X.x, X.y, X.z};
}

}  // namespace

void Air::populate(const world::World& world) {
  warm_.clear();
  for (const world::ModelRow row : world.models.rows())
    if (world.desc(row).heat != 0) warm_.push_back(row);
}

double Air::temperature(const world::World& world, world::ModelRow model, const OpenAir& open) const {
  const geom::Vec3 p = middle_of(world, model);
  double temperature = open.ambient - open.lapse * p.z;
  for (const world::ModelRow each : warm_) {
    const scene::ModelDesc& ball = world.desc(each);
    const geom::Vec3 way = middle_of(world, each) - p;
    temperature += ball.heat * ball.heat_radius / std::max(std::sqrt(dot(way, way)), ball.heat_radius);
  }
  return temperature;
}

}  // namespace playhouse::senses
