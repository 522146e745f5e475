#pragma once

/// sin, cos and atan2 from additions and multiplications only, so that every compiler, library and
/// optimisation level gives the same bits; the simulation uses these and never <cmath>'s. Angles in radians.
/// Source: Taylor series on [-pi/4, pi/4] after Cody-Waite reduction; errors are measured in trig_test.cc.

namespace playhouse::geom {

inline constexpr double kPi = 3.14159265358979323846;
inline constexpr double kTwoPi = 2.0 * kPi;

struct SinCos {
  double sin, cos;
};

/// Absolute error below 1e-15 for |angle| <= 1e5.
SinCos sincos(double angle);

/// In (-pi, pi]; atan2(0, 0) is 0. Absolute error below 1e-15.
double atan2(double y, double x);

/// Normalises an angle to (-pi, pi].
double normalize(double angle);

constexpr double radians(double degrees) {
  return degrees * (kPi / 180.0);
}
constexpr double degrees(double radians) {
  return radians * (180.0 / kPi);
}

}  // namespace playhouse::geom
