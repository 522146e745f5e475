#pragma once

/// The light of sun and sky by the words `sun` and `sky` of a world file. A pure function.

#include <cstdint>

#include "playhouse/geom/orientation.h"
#include "playhouse/scene/scene_desc.h"

namespace playhouse::scene {

inline constexpr std::uint32_t kFloorColor = 0xd9d9d2;  // 0xRRGGBB, in images and in the page

struct Daylight {
  geom::Vec3 to_sun = {0, 0, 1};  // unit, in W
  float sun = 0;                  // how bright it makes a white face that is square to it
  float ambient = 0;              // and the light from everywhere
  float day = 1;                  // share of the colors of sky and fog: below 1 from dusk on
  float white_lux = 2000;  // of lamps that make a white face as bright as 1: the exposure follows the sun
};
Daylight daylight_of(const WorldDesc& world);

}  // namespace playhouse::scene
