#include "playhouse/arena/surface.h"

#include <array>
#include <string_view>

namespace playhouse::arena {
namespace {

struct Material {
  std::string_view name;
  Surface surface;
};

// Coefficients towards concrete, which has 1. Source: ranges of sliding friction in Oberg, "Machinery's
// Handbook"; of ice on steel, 0.03 to 0.05.
constexpr std::array kMaterials = {
    Material{"concrete", {1, 0.1}}, Material{"asphalt", {1, 0.1}}, Material{"carpet", {1, 0}},
    Material{"rubber", {1, 0.6}},   Material{"wood", {0.6, 0.3}},  Material{"plastic", {0.5, 0.4}},
    Material{"steel", {0.4, 0.3}},  Material{"glass", {0.4, 0.3}}, Material{"ice", {0.05, 0}},
};
constexpr Surface kUnknown{0.6, 0};

}  // namespace

Surface surface_of(const scene::ModelDesc& desc) {
  Surface surface = kUnknown;
  for (const Material& material : kMaterials)
    if (material.name == desc.material) surface = material.surface;
  if (desc.friction > 0) surface.friction = desc.friction;
  return surface;
}

}  // namespace playhouse::arena
