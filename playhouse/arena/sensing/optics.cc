#include "playhouse/arena/sensing/optics.h"

#include <algorithm>

#include "playhouse/scene/forms/materials.h"

namespace playhouse::arena {
namespace {

constexpr double kDarkest = 0.02, kBrightest = 0.9;  // limits of diffuse reflectance: tyre, white paper

}  // namespace

Optics optics_of(std::string_view material) {
  const scene::NamedMaterial& known = scene::material_named(material);
  return {known.scatters, known.mirrors, known.passes};
}

/// Luminance of linear light by ITU-R BT.709; colors are squared as an approximation of sRGB decoding.
double scatters(const scene::Color& color) {
  const double r = color.r, g = color.g, b = color.b;
  return std::clamp(0.2126 * r * r + 0.7152 * g * g + 0.0722 * b * b, kDarkest, kBrightest);
}

Optics met_at(const Optics& surface, double facing) {
  if (surface.passes == 0) return surface;
  const double slant = 1 - std::clamp(facing, 0.0, 1.0), square = slant * slant;
  Optics at = surface;
  at.mirrors = surface.mirrors + (1 - surface.mirrors) * square * square * slant;
  at.passes = std::max(0.0, 1 - at.mirrors - surface.scatters);
  return at;
}

}  // namespace playhouse::arena
