#pragma once

/// The solid shape of a model: blocks and traced bitmaps, stretched together so that they fill the model's
/// size.

#include <optional>
#include <vector>

#include "playhouse/scene/properties.h"

namespace playhouse::scene {

/// Blocks and contours in the file's own units, before they are stretched.
struct Shape {
  /// A block whose z is absent stands as high as the whole model.
  struct Prism {
    std::vector<geom::Vec2> points;
    std::optional<Bounds> z;
    SourceLine where;
  };
  std::vector<Prism> prisms;
  std::vector<std::vector<geom::Vec2>> contours;  // of one bitmap, in pixels; z from 0 to 1
};

/// Reads a `block ( points N point[i] [x y] ... z [min max] )`. A missing point is [0 0], with a warning.
Shape::Prism read_block(const Properties& properties);

/// Stretches `shape` so that its bounding box is `size`: centred on the origin in x and y, standing on z = 0.
/// A block that is a line becomes a thin wall, with a warning.
void fit_shape(const Shape& shape, const geom::Size& size, LoadState& state, ModelDesc& model);

/// One block that fills `size`.
Block box_block(const geom::Size& size);

/// Four walls, 0.01 m thick, inside the edges of `size`, as high as it.
std::vector<Block> boundary_walls(const geom::Size& size);

}  // namespace playhouse::scene
