#pragma once

/// Lighting by the words `sun` and `sky` of a world file. A pure function.

#include <cstdint>

#include "playhouse/geom/orientation.h"
#include "playhouse/scene/scene_desc.h"

namespace playhouse::scene {

inline constexpr std::uint32_t kFloorColor = 0xd9d9d2;  // 0xRRGGBB, in images and in the page

struct Daylight {
  geom::Vec3 to_sun = {0, 0, 1};  // unit, in W
  float sun = 0;                  // irradiance on a face towards it, as the brightness of a white face
  float ambient = 0;              // the same for ambient light
  float day = 1;                  // factor on sky and fog colours: below 1 from dusk on
  float white_lux = 2000;  // illuminance that makes a white face as bright as 1: exposure follows the sun
};
Daylight daylight_of(const WorldDesc& world);

}  // namespace playhouse::scene
