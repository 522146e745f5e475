#include "playhouse/senses/air.h"

#include <algorithm>
#include <cmath>

#include "playhouse/senses/body_motion.h"

namespace playhouse::senses {
namespace {

geom::Vec3 middle_of(const world::World& world, world::ModelRow model) {
  const geom::Pose X = middle_of_body(world, model).X;
  return {X.x, X.y, X.z};
}

}  // namespace

void Air::populate(const world::World& world, std::size_t sensors) {
  warm_.clear();
  if (sensors == 0) return;
  for (const world::ModelRow row : world.models.rows())
    if (world.desc(row).heat != 0) warm_.push_back(row);
  balls_.reserve(warm_.size());
}

void Air::begin_tick(const world::World& world) {
  balls_.clear();
  for (const world::ModelRow row : warm_) {
    const scene::ModelDesc& desc = world.desc(row);
    balls_.push_back({middle_of(world, row), desc.heat * desc.heat_radius, desc.heat_radius});
  }
}

double Air::temperature(const world::World& world, world::ModelRow model, const OpenAir& open) const {
  const geom::Vec3 p = middle_of(world, model);
  double temperature = open.ambient - open.lapse * p.z;
  for (const Ball& ball : balls_) {
    const geom::Vec3 way = ball.middle - p;
    temperature += ball.excess / std::max(std::sqrt(dot(way, way)), ball.radius);
  }
  return temperature;
}

}  // namespace playhouse::senses
