#pragma once

/// What surfaces do to the light of a lidar.
///
/// In: the material of a model, its colour, how many times brighter than that it is (`ranger_return`).
///
/// Out: shares of the light that a surface scatters, mirrors and lets through; how much of it comes back.
///
/// Source: Lambert's law and the lidar equation for surfaces larger than the beam, P ~ rho cos(theta) / r^2
/// (Kashani et al., "A review of LiDAR radiometric processing", Sensors 2015); glass by Schlick, "An
/// inexpensive BRDF model for physically-based rendering", 1994; reflectances at 0.9 um: scene/materials.cc.

#include <string_view>

#include "playhouse/scene/scene_desc.h"

namespace playhouse::arena {

/// Shares of the light that meets a surface, square on.
struct Optics {
  double scatters = 0;  // diffuse reflectance, as seen from straight ahead; below 0: as its colour says
  double mirrors = 0;
  double passes = 0;
};

/// Of what is made of nothing that is known, the share that it scatters is below 0.
Optics optics_of(std::string_view material);

/// The share of light that a colour scatters.
double scatters(const scene::Color& color);

/// The same surface, met at an angle; `facing` is its cosine to the normal. What is clear mirrors more, and
/// lets less through, the more slanted it is.
Optics met_at(const Optics& surface, double facing);

/// What comes back from `range` of which a share `returned` is sent towards the lidar; 1 is a white sheet at
/// a metre.  [m]
constexpr double echo_power(double returned, double range) {
  const double far = range > 1 ? range : 1;  // nearer the lens does not see all of the spot
  return returned / (far * far);
}

}  // namespace playhouse::arena
