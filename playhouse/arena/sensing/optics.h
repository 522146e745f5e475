#pragma once

/// Optics of surfaces at a lidar's wavelength.
///
/// In: the material of a model, its colour, and `ranger_return` as a factor of brightness.
///
/// Out: shares of light scattered, reflected and transmitted; the power of the echo.
///
/// Cost: some products for each hit; a search for the name of a material once for each model.
///
/// Source: Lambert's law and the lidar equation for surfaces larger than the beam, P ~ rho cos(theta) / r^2
/// (Kashani et al., "A review of LiDAR radiometric processing", Sensors 2015); glass by Schlick, "An
/// inexpensive BRDF model for physically-based rendering", 1994; reflectances at 0.9 um:
/// scene/forms/materials.cc.

#include <string_view>

#include "playhouse/scene/scene_desc.h"

namespace playhouse::arena {

/// Shares of the light at normal incidence.
struct Optics {
  double scatters = 0;  // diffuse reflectance at normal incidence; below 0: by its colour
  double mirrors = 0;
  double passes = 0;
};

/// For an unknown material `scatters` is below 0.
Optics optics_of(std::string_view material);

/// Diffuse reflectance of a colour.
double scatters(const scene::Color& color);

/// The shares at an angle of incidence; `facing` is the cosine to the normal.
/// Transparent surfaces reflect more and transmit less at grazing angles (Fresnel).
Optics met_at(const Optics& surface, double facing);

/// Echo power at `range` when a share `returned` of the light
/// goes towards the lidar; 1 for a white sheet at one metre. [m]
constexpr double echo_power(double returned, double range) {
  const double far = range > 1 ? range : 1;  // closer, the lens sees only a part of the spot
  return returned / (far * far);
}

}  // namespace playhouse::arena
