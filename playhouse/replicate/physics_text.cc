#include "playhouse/replicate/physics_text.h"

#include <fmt/format.h>

#include "playhouse/replicate/json_text.h"

namespace playhouse::replicate {
namespace {

using world::SolidCorners;

/// True if the second half of the corners is above the first half, as for an upright prism.
bool is_prism(const SolidCorners& corners) {
  const std::size_t half = corners.size() / 2;
  if (half == 0 || corners.size() % 2 != 0) return false;
  for (std::size_t k = 0; k < half; ++k) {
    const geom::Vec3 &low = corners[k], &high = corners[half + k];
    const bool is_above = low.x == high.x && low.y == high.y;
    if (!is_above || low.z != corners[0].z || high.z != corners[half].z) return false;
  }
  return true;
}

std::string solid_text(const SolidCorners& corners) {
  std::string points;
  const auto add = [&points](double value) { points += (points.empty() ? "" : ",") + number(value); };
  if (!is_prism(corners)) {
    for (const geom::Vec3& p : corners)
      for (const double value : {p.x, p.y, p.z}) add(value);
    return fmt::format(R"({{"corners":[{}]}})", points);
  }
  const std::size_t half = corners.size() / 2;
  for (std::size_t k = 0; k < half; ++k)
    for (const double value : {corners[k].x, corners[k].y}) add(value);
  return fmt::format(R"({{"z":[{},{}],"loop":[{}]}})", number(corners[0].z), number(corners[half].z), points);
}

}  // namespace

Result<std::string> physics_text(const world::PhysicsShapes& shapes) {
  std::size_t corners = 0;
  for (const SolidCorners& solid : shapes.fixed) corners += solid.size();
  for (const auto& body : shapes.bodies)
    for (const SolidCorners& solid : body.solids) corners += solid.size();
  if (corners > kPhysicsCorners)
    return Error{"", fmt::format("physics has {} corners here: more than the {} that a page is told of",
                                 corners, kPhysicsCorners)};
  const auto body_text = [](const world::PhysicsShapes::Body& body) {
    return fmt::format(R"({{"model":{},"solids":{}}})", body.model.value, list(body.solids, solid_text));
  };
  return fmt::format("{{\"physics\":{{\"fixed\":{},\n\"bodies\":{}}}}}\n", list(shapes.fixed, solid_text),
                     list(shapes.bodies, body_text));
}

}  // namespace playhouse::replicate
