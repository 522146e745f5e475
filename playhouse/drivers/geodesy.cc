#include "playhouse/drivers/geodesy.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>

#include "playhouse/geom/trig.h"

namespace playhouse::drivers {
namespace {

// WGS84: equatorial radius and flattening.
constexpr double kRadius = 6378137.0, kFlattening = 1 / 298.257223563;
constexpr double kSquared = kFlattening * (2 - kFlattening);  // eccentricity squared
constexpr double kScale = 0.9996;                             // of UTM at the central meridian
constexpr double kFalseEasting = 500e3, kFalseNorthing = 10000e3;
constexpr double kSteepest = 89.9999999;  // degrees; at a pole the meridian is undefined

struct Spatial {
  double x = 0, y = 0, z = 0;  // m, earth-centred: x to longitude 0, z to the north pole
};

/// Radius of curvature in the prime vertical.  [m]
double across(double latitude) {
  const double s = std::sin(latitude);
  return kRadius / std::sqrt(1 - kSquared * s * s);
}

Spatial spatial(const Geodetic& at) {
  const double n = across(at.latitude), level = (n + at.height) * std::cos(at.latitude);
  return {level * std::cos(at.longitude), level * std::sin(at.longitude),
          (n * (1 - kSquared) + at.height) * std::sin(at.latitude)};
}

Geodetic geodetic(const Spatial& p) {
  constexpr int kRounds = 4;  // each adds five digits near the surface
  const double level = std::hypot(p.x, p.y), minor = kRadius * (1 - kFlattening);
  const double second = kSquared / (1 - kSquared);
  double reduced = std::atan2(p.z, level * (1 - kFlattening)), latitude = 0;
  for (int round = 0; round < kRounds; ++round) {
    const double s = std::sin(reduced), c = std::cos(reduced);
    latitude = std::atan2(p.z + second * minor * s * s * s, level - kSquared * kRadius * c * c * c);
    reduced = std::atan2((1 - kFlattening) * std::sin(latitude), std::cos(latitude));
  }
  const double s = std::sin(latitude), c = std::cos(latitude);
  const double height = level * c + p.z * s - kRadius * std::sqrt(1 - kSquared * s * s);
  return {latitude, std::atan2(p.y, p.x), height};
}

}  // namespace

Geodetic place_on_earth(const Geodetic& origin, double east, double north, double up) {
  const Spatial o = spatial(origin);
  const double sp = std::sin(origin.latitude), cp = std::cos(origin.latitude);
  const double sl = std::sin(origin.longitude), cl = std::cos(origin.longitude);
  return geodetic({o.x - sl * east - sp * cl * north + cp * cl * up,
                   o.y + cl * east - sp * sl * north + cp * sl * up, o.z + cp * north + sp * up});
}

Utm utm_of(const Geodetic& place) {
  constexpr double n = kFlattening / (2 - kFlattening), n2 = n * n, n3 = n2 * n, n4 = n2 * n2;
  constexpr double kRectifying = kRadius / (1 + n) * (1 + n2 / 4 + n4 / 64);
  constexpr std::array kAlpha = {n / 2 - 2 * n2 / 3 + 5 * n3 / 16 + 41 * n4 / 180,
                                 13 * n2 / 48 - 3 * n3 / 5 + 557 * n4 / 1440, 61 * n3 / 240 - 103 * n4 / 140,
                                 49561 * n4 / 161280};
  const double degrees = geom::degrees(place.longitude);
  const int zone = std::clamp(static_cast<int>(std::floor((degrees + 180) / 6)) + 1, 1, 60);
  const double longitude = geom::normalize(place.longitude - geom::radians(6 * zone - 183));
  const double steepest = geom::radians(kSteepest),
               latitude = std::clamp(place.latitude, -steepest, steepest);
  // Conformal latitude, spherical transverse Mercator, then the series for the ellipsoid.
  const double e = std::sqrt(kSquared), tau = std::tan(latitude), root = std::hypot(1.0, tau);
  const double sigma = std::sinh(e * std::atanh(e * tau / root));
  const double conformal = tau * std::hypot(1.0, sigma) - sigma * root;
  const double xi = std::atan2(conformal, std::cos(longitude));
  const double eta = std::asinh(std::sin(longitude) / std::hypot(conformal, std::cos(longitude)));
  const std::complex<double> sphere(xi, eta);
  std::complex<double> ellipsoid = sphere;
  for (std::size_t j = 0; j < kAlpha.size(); ++j)
    ellipsoid += kAlpha[j] * std::sin(2.0 * static_cast<double>(j + 1) * sphere);
  const bool is_south = place.latitude < 0;
  return {is_south ? -zone : zone, kFalseEasting + kScale * kRectifying * ellipsoid.imag(),
          kScale * kRectifying * ellipsoid.real() + (is_south ? kFalseNorthing : 0)};
}

}  // namespace playhouse::drivers
