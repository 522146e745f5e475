#include "playhouse/scene/daylight.h"

#include <algorithm>

#include "playhouse/geom/trig.h"

namespace playhouse::scene {
namespace {

constexpr float kSunlight = 0.72f, kAmbient = 0.42f,
                kNight = 0.05f;     // at noon both together are a little over 1
constexpr double kTwilight = 0.35;  // sine of the elevation of a sun that is up altogether
constexpr double kMostBrightness = 100;

}  // namespace

Daylight daylight_of(const WorldDesc& world) {
  const geom::SinCos heading = geom::sincos(world.sun_heading), up = geom::sincos(world.sun_elevation);
  Daylight light;
  light.to_sun = {up.cos * heading.cos, up.cos * heading.sin, up.sin};
  light.sun = kSunlight * static_cast<float>(std::clamp(world.sun_brightness, 0.0, kMostBrightness));
  light.ambient = kNight + (kAmbient - kNight) * static_cast<float>(std::clamp(up.sin / kTwilight, 0.0, 1.0));
  light.day = light.ambient / kAmbient;
  return light;
}

}  // namespace playhouse::scene
