#pragma once

/// Covariance of a planar pose.

namespace playhouse::client {

/// Covariance of a planar pose: of x, y (m) and a (rad). xx, yy and aa are variances.
struct Covariance {
  double xx = 0, yy = 0, aa = 0;
  double xy = 0, ya = 0, xa = 0;
  friend bool operator==(const Covariance&, const Covariance&) = default;

  /// That of independent errors with these standard deviations, in m, m and rad.
  static Covariance of_deviations(double x, double y, double a) { return {x * x, y * y, a * a}; }
};

}  // namespace playhouse::client
