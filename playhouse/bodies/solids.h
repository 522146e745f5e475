#pragma once

/// Solids: the prisms that bodies are made of, in the world, for tests of places before anything moves.
///
/// In: the description of an obstacle, and a pose.
/// Out: its prisms in W.
/// Cost: their vertices.

#include <cstdint>
#include <span>
#include <vector>

#include "playhouse/bodies/overlap.h"
#include "playhouse/geom/pose.h"
#include "playhouse/scene/scene_desc.h"

namespace playhouse::bodies {

/// A prism in W: a polygon from `bottom` to `top`. [m]
struct Solid {
  std::vector<geom::Vec2> p;
  double bottom = 0, top = 0;
};

/// Points in W of points in B.
std::vector<geom::Vec2> moved(const geom::Pose& X_WB, std::span<const geom::Vec2> points);

/// Appends the blocks of a model at X_WM; none if it is no obstacle.
void add_blocks(const scene::ModelDesc& desc, const geom::Pose& X_WM, std::vector<Solid>& solids);

/// The polygon of a solid, which must outlive it.
Polygon outline_of(const Solid& solid);

/// True if the heights of a solid and of [bottom, top] overlap.
bool share_heights(const Solid& solid, double bottom, double top);

}  // namespace playhouse::bodies
