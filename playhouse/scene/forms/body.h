#pragma once

/// The solid shape of a model: blocks and traced
/// bitmaps, scaled jointly to the model's size.

#include <optional>
#include <vector>

#include "playhouse/scene/properties.h"
#include "playhouse/scene/scene_desc.h"

namespace playhouse::scene {

/// Blocks and contours in file units, before scaling.
struct UnscaledBody {
  std::vector<Prism> prisms;
  std::vector<std::vector<geom::Vec2>> contours;  // of one bitmap, in pixels; z from 0 to 1
};

/// Reads a `block ( points N point[i] [x y] ... z [min max] )`. A missing point
/// defaults to [0 0], a missing z to the height of the model, each with a warning.
Prism read_block(const Properties& properties);

/// Scales `shape` to the bounding box `size`, centred on the origin in x and y. In z
/// the interval from the floor, z = 0, to the highest point is scaled, so that floating
/// parts stay above the floor. A degenerate block becomes a thin wall, with a warning.
void fit_shape(const UnscaledBody& shape, const geom::Size& size, LoadState& state, ModelDesc& model);

/// The size for a body to fill: `size`, with zero x or y
/// replaced by a wall's thickness; none if both are 0.
std::optional<geom::Size> body_size(const geom::Size& size);
/// Warns of a size that is zero in x, y or z.
void check_body_size(const geom::Size& size, const Properties& properties);

/// An axis-aligned block in B. [m]
Block rectangle(double x_min, double y_min, double x_max, double y_max, Interval z);

/// One block of this size.
Block box_block(const geom::Size& size);

/// Four walls, 0.01 m thick, along the inside of `size`, of its height.
std::vector<Block> boundary_walls(const geom::Size& size);

}  // namespace playhouse::scene
