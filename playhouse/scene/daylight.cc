#include "playhouse/scene/daylight.h"

#include <algorithm>
#include <cmath>

#include "playhouse/geom/trig.h"

namespace playhouse::scene {
namespace {

constexpr float kSunlight = 0.72f, kAmbient = 0.42f,
                kNight = 0.05f;     // at noon both together are a little over 1
constexpr double kTwilight = 0.35;  // sine of the elevation of a sun that is up altogether
constexpr double kMostBrightness = 100;
constexpr float kNightLux = 20,
                kDayLux = 2000;  // Daylight::white_lux; by day as Blender shows 1 W of light as 683 lm

}  // namespace

Daylight daylight_of(const WorldDesc& world) {
  const geom::SinCos heading = geom::sincos(world.sun_heading), up = geom::sincos(world.sun_elevation);
  Daylight light;
  light.to_sun = {up.cos * heading.cos, up.cos * heading.sin, up.sin};
  light.sun = kSunlight * static_cast<float>(std::clamp(world.sun_brightness, 0.0, kMostBrightness));
  const auto risen = static_cast<float>(std::clamp(up.sin / kTwilight, 0.0, 1.0));
  light.ambient = kNight + (kAmbient - kNight) * risen;
  light.day = light.ambient / kAmbient;
  light.white_lux = kNightLux * std::pow(kDayLux / kNightLux, risen);
  return light;
}

}  // namespace playhouse::scene
