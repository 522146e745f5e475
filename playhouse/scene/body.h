#pragma once

/// The solid shape of a model: blocks and traced bitmaps, stretched together so that they fill the model's
/// size.

#include <optional>
#include <vector>

#include "playhouse/scene/properties.h"

namespace playhouse::scene {

/// Blocks and contours in the file's own units, before they are stretched.
struct Shape {
  std::vector<Prism> prisms;
  std::vector<std::vector<geom::Vec2>> contours;  // of one bitmap, in pixels; z from 0 to 1
};

/// Reads a `block ( points N point[i] [x y] ... z [min max] )`. A missing point is [0 0] and a missing z the
/// height of the model, each with a warning.
Prism read_block(const Properties& properties);

/// Stretches `shape` so that its bounding box is `size`: centred on the origin in x and y. In z it is the
/// interval from the floor, z = 0, to the highest point that is stretched, so that what floats stays above
/// the floor. A block that is a line becomes a thin wall, with a warning.
void fit_shape(const Shape& shape, const geom::Size& size, LoadState& state, ModelDesc& model);

/// The size for a body to fill: `size`, but a wall's thickness where that has no extent in x or y. Nothing if
/// both are 0.
std::optional<geom::Size> body_size(const geom::Size& size);
/// Warns of a size that has no extent in x, y or z.
void check_body_size(const geom::Size& size, const Properties& properties);

/// A block with sides along the axes of B. [m]
Block rectangle(double x_min, double y_min, double x_max, double y_max, Bounds z);

/// One block that fills `size`.
Block box_block(const geom::Size& size);

/// Four walls, 0.01 m thick, inside the edges of `size`, as high as it.
std::vector<Block> boundary_walls(const geom::Size& size);

}  // namespace playhouse::scene
