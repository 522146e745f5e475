#pragma once

/// Priority accumulator, for a viewer that has no room for all rows: deferred rows gain weight every frame,
/// so none starves, and the important ones go more often.

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "playhouse/replicate/delta.h"

namespace playhouse::replicate {

inline constexpr double kLeastImportance = 0.05;

/// Distance of a model from the viewer's copy. [mm], rotation as the arc at a radius of 0.2 m
inline double change_of(const ModelState& held, const ModelState& is) {
  const double turn = std::abs(static_cast<std::int16_t>(static_cast<std::uint16_t>(is.a - held.a)));
  const double way = std::abs(double{1} * is.x - held.x) + std::abs(double{1} * is.y - held.y) +
                     std::abs(double{1} * is.z - held.z);
  const bool looks_other = held.state != is.state || held.color != is.color || held.flags != is.flags ||
                           held.tilt_x != is.tilt_x || held.tilt_y != is.tilt_y;
  return way + turn * (6.2832 / 65536 * 200) + (looks_other ? 100 : 0);
}

/// Priority weight: 1 for a model at the centre of the view that has
/// changed little; at least kLeastImportance. `at` is the place of its tree's root.
inline double importance(const Wish& wish, bool is_selected, geom::Vec2 at, double change) {
  constexpr double kSelected = 16, kNear = 10;  // times, m
  if (is_selected) return kSelected;
  double weight = 1 + std::min(change / 100, 10.0);
  if (!wish.view.empty()) {
    const double x = at.x - (wish.view.x_min + wish.view.x_max) / 2;
    const double y = at.y - (wish.view.y_min + wish.view.y_max) / 2;
    weight /= 1 + std::sqrt(x * x + y * y) / kNear;
  }
  return std::max(weight, kLeastImportance);
}

/// True if the view covers only a part of the world and `at` is outside it.
inline bool is_out_of_view(const Wish& wish, geom::Vec2 at) {
  return !wish.view.empty() && !wish.view.contains(at);
}

}  // namespace playhouse::replicate
