#include "playhouse/arena/optics.h"

#include <algorithm>
#include <array>

namespace playhouse::arena {
namespace {

struct Material {
  std::string_view name;
  Optics optics;
};

constexpr double kAsColour = -1;
constexpr double kDarkest = 0.02, kBrightest = 0.9;  // of surfaces that scatter: a tyre, white paper

// What they scatter at 0.9 um is as RIEGL tells customers of its rangefinders ("Reflectance of materials"):
// white paper up to 100 %, smooth concrete 24 %, asphalt with pebbles 17 %, a clean rough pallet 25 %, black
// neoprene 5 %, a tyre's wall 2 %. Grey PVC 50 %: SICK, technical description of the LMS 200. Glass of index
// 1.52 mirrors 4.3 % at each face (Fresnel), and has a little dust; silvered glass mirrors about 90 % there;
// that brushed steel scatters half of the 60 % that it returns is our choice.
constexpr std::array kMaterials = {
    Material{"paper", {0.9, 0, 0}},       Material{"concrete", {0.24, 0, 0}},
    Material{"asphalt", {0.17, 0, 0}},    Material{"wood", {0.25, 0, 0}},
    Material{"plastic", {0.5, 0, 0}},     Material{"neoprene", {0.05, 0, 0}},
    Material{"rubber", {0.02, 0, 0}},     Material{"steel", {0.3, 0.3, 0}},
    Material{"glass", {0.002, 0.043, 1}}, Material{"mirror", {0.002, 0.9, 0}},
};

}  // namespace

Optics optics_of(std::string_view material) {
  for (const Material& each : kMaterials)
    if (each.name == material) return each.optics;
  return {kAsColour, 0, 0};
}

/// Luminance of linear light by ITU-R BT.709; colours are stored with a gamma of about 2.
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
