#include "playhouse/geom/trig.h"

#include <bit>
#include <cmath>
#include <cstdint>

namespace playhouse::geom {
namespace {

// pi/2 in two parts: the first has 33 significant bits, so n * kHalfPiHigh is exact for |n| < 2^20.
constexpr double kHalfPiHigh = 1.57079632673412561417e+00;
constexpr double kHalfPiLow = 6.07710050650619224932e-11;

/// Rounds to nearest, ties to even; |v| < 2^51.
double nearest_whole(double v) {
  constexpr double kWhole = 6755399441055744;  // 1.5 * 2^52: no fractional bits remain
  return (v + kWhole) - kWhole;
}

/// c[0] + c[1] z + ... + c[7] z^7 by Estrin's
/// scheme, which shortens the dependency chain.
double polynomial(const double (&c)[8], double z, double z2, double z4) {
  const double low = (c[0] + c[1] * z) + (c[2] + c[3] * z) * z2;
  const double high = (c[4] + c[5] * z) + (c[6] + c[7] * z) * z2;
  return low + high * z4;
}

/// sin on [-pi/4, pi/4]: Taylor to x^17, remainder below 1e-19.
double sin_small(double x) {
  constexpr double kTaylor[] = {
      -1.0 / 6.0,        1.0 / 120.0,        -1.0 / 5040.0,          1.0 / 362880.0,
      -1.0 / 39916800.0, 1.0 / 6227020800.0, -1.0 / 1307674368000.0, 1.0 / 355687428096000.0};
  const double z = x * x, z2 = z * z;
  return x + x * z * polynomial(kTaylor, z, z2, z2 * z2);
}

/// cos on [-pi/4, pi/4]: Taylor to x^18.
double cos_small(double x) {
  constexpr double kTaylor[] = {
      1.0 / 24.0,        -1.0 / 720.0,         1.0 / 40320.0,          -1.0 / 3628800.0,
      1.0 / 479001600.0, -1.0 / 87178291200.0, 1.0 / 20922789888000.0, -1.0 / 6402373705728000.0};
  const double z = x * x, z2 = z * z;
  return 1.0 - 0.5 * z + z2 * polynomial(kTaylor, z, z2, z2 * z2);
}

/// atan on [0, tan(pi/16)]: alternating series to x^25, remainder below 1e-19.
double atan_small(double x) {
  constexpr double kSeries[] = {-1.0 / 3,  1.0 / 5,  -1.0 / 7,  1.0 / 9,
                                -1.0 / 11, 1.0 / 13, -1.0 / 15, 1.0 / 17};
  constexpr double kTail[] = {-1.0 / 19, 1.0 / 21, -1.0 / 23, 1.0 / 25};
  const double z = x * x, z2 = z * z, z4 = z2 * z2;
  const double tail = (kTail[0] + kTail[1] * z) + (kTail[2] + kTail[3] * z) * z2;
  return x + x * z * (polynomial(kSeries, z, z2, z4) + tail * (z4 * z4));
}

/// atan on [0, 1]: argument reduction by the nearest of 0, pi/8, pi/4, for fast convergence.
double atan_unit(double x) {
  constexpr double kTanSixteenth = 0.19891236737965800691;  // tan(pi/16)
  constexpr double kTanThreeSixteenths = 0.66817863791929891999;
  constexpr double kTanEighth = 0.41421356237309504880;  // tan(pi/8)
  if (x <= kTanSixteenth) return atan_small(x);
  const bool near_eighth = x <= kTanThreeSixteenths;
  const double t = near_eighth ? kTanEighth : 1.0;
  const double turned = (x - t) / (1.0 + x * t);
  return (near_eighth ? kPi / 8.0 : kPi / 4.0) + (turned < 0 ? -atan_small(-turned) : atan_small(turned));
}

}  // namespace

SinCos sincos(double angle) {
  const double n = nearest_whole(angle * (2.0 / kPi));
  const double x = (angle - n * kHalfPiHigh) - n * kHalfPiLow;
  const double both[2] = {sin_small(x), cos_small(x)};
  // Branch-free: quadrants are unpredictable. sin: s, c, -s, -c; cos: c, -s, -c, s.
  // Values may come from a corrupt state: out of integer range, quadrant 0.
  const double turns = std::fabs(n) < 0x1p62 ? n : 0;
  const auto quadrant = static_cast<std::uint64_t>(static_cast<std::int64_t>(turns)) & 3;
  const auto turned = [&](std::uint64_t which, std::uint64_t negative) {
    return std::bit_cast<double>(std::bit_cast<std::uint64_t>(both[which & 1]) ^ (negative & 2) << 62);
  };
  return {turned(quadrant, quadrant), turned(quadrant + 1, quadrant + 1)};
}

double atan2(double y, double x) {
  const double ax = std::fabs(x), ay = std::fabs(y);
  if (ax == 0.0 && ay == 0.0) return 0.0;
  double angle = ay <= ax ? atan_unit(ay / ax) : kPi / 2.0 - atan_unit(ax / ay);
  if (x < 0.0) angle = kPi - angle;
  return y < 0.0 ? -angle : angle;
}

double normalize(double angle) {
  if (angle > -kPi && angle <= kPi) return angle;
  // Clients may send any number; for many turns the product below would be inexact.
  constexpr double kManyTurns = 1e6;
  const double turned = std::fabs(angle) < kManyTurns ? angle - kTwoPi * std::floor((angle + kPi) / kTwoPi)
                                                      : std::remainder(angle, kTwoPi);
  return turned <= -kPi ? turned + kTwoPi : turned;
}

}  // namespace playhouse::geom
