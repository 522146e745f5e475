#include "playhouse/scene/forms/daylight.h"

#include <algorithm>

#include "playhouse/geom/trig.h"

namespace playhouse::scene {
namespace {

constexpr float kSunlight = 0.72f, kAmbient = 0.42f,
                kNight = 0.05f;     // at noon both add up to slightly over 1
constexpr double kTwilight = 0.35;  // sine of the elevation above which the sun is fully up
constexpr double kMostBrightness = 100;
constexpr double kNightLux = 20;  // Daylight::white_lux; 100 times that by day, as Blender shows lamps

/// About 100 to the power of `share`, bit-reproducible.
double brightening(double share) {
  double factor = 1 + share * 0.0746078283;  // the 64th root of 100, less 1
  for (int i = 0; i < 6; ++i) factor *= factor;
  return factor;
}

}  // namespace

Daylight daylight_of(const WorldDesc& world) {
  const geom::SinCos heading = geom::sincos(world.sun_heading), up = geom::sincos(world.sun_elevation);
  Daylight light;
  light.to_sun = {up.cos * heading.cos, up.cos * heading.sin, up.sin};
  light.sun = kSunlight * static_cast<float>(std::clamp(world.sun_brightness, 0.0, kMostBrightness));
  const auto risen = static_cast<float>(std::clamp(up.sin / kTwilight, 0.0, 1.0));
  light.ambient = kNight + (kAmbient - kNight) * risen;
  light.day = light.ambient / kAmbient;
  light.white_lux = static_cast<float>(kNightLux * brightening(risen));
  return light;
}

}  // namespace playhouse::scene
