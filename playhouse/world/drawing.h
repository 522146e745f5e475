#pragma once

/// Drawings of models, for viewers alone: points, lines and triangles in the frame of the model, that clients
/// add to one of two layers and clear. No sensor sees them, and no hash has them.

#include <cstdint>
#include <span>

#include "playhouse/geom/orientation.h"
#include "playhouse/world/world.h"

namespace playhouse::world {

/// Who draws in which layer.
inline constexpr std::uint32_t kLayer2d = 0, kLayer3d = 1, kLayers = 2;

/// Shapes of one kind and color.
struct DrawnShapes {
  std::uint32_t layer = kLayer2d;
  std::uint32_t corners = 1;  // of each shape: 1, 2 or 3
  scene::Color color;
  std::span<const geom::Vec3> points;  // m, in the frame of the model
};

/// Adds shapes to the drawing of a model. False, without effect, if that would not be a drawing.
bool draw(World& world, ModelRow model, const DrawnShapes& shapes);
void clear_drawing(World& world, ModelRow model, std::uint32_t layer);

/// True if every shape has all its corners, finite and of one color and layer, and no layer has more than
/// limits::kDrawnCorners.
bool is_drawing(std::span<const DrawnCorner> drawing);
/// How many of its corners are in a layer.
std::size_t corners_in(std::span<const DrawnCorner> drawing, std::uint32_t layer);

}  // namespace playhouse::world
