#pragma once

/// Localization of a robot on a map. SI units and radians.

#include <optional>
#include <vector>

#include "playhouse/wire/generated/localize.h"
#include "playhouse_client/client.h"
#include "playhouse_client/pose.h"

namespace playhouse::client {

/// Covariance of a planar pose: of x, y (m) and a (rad). xx, yy and aa are variances.
struct Covariance {
  double xx = 0, yy = 0, aa = 0;
  double xy = 0, ya = 0, xa = 0;
  friend bool operator==(const Covariance&, const Covariance&) = default;

  /// That of independent errors with these standard deviations, in m, m and rad.
  static Covariance of_deviations(double x, double y, double a) { return {x * x, y * y, a * a}; }
};

/// A hypothesis about where the robot is: mean pose on the map, its covariance, and its weight; the weights
/// of all sum to 1.
struct Hypothesis {
  Pose pose;
  Covariance covariance;
  double weight = 0;
  friend bool operator==(const Hypothesis&, const Hypothesis&) = default;
};

/// A particle of the filter: a possible pose of the robot on the map, and its weight.
struct Particle {
  Pose pose;
  double weight = 0;
  friend bool operator==(const Particle&, const Particle&) = default;
};

class Localize {
 public:
  static Result<Localize> open(Client& client, std::uint16_t index, Access access = Access::kAll);

  /// Where the robot may be, the most likely first; empty before the first data.
  std::vector<Hypothesis> hypotheses() const;

  /// The pose on the map of the most likely hypothesis; none before the first data, and if there is none.
  std::optional<Pose> pose() const;

  /// Sets the estimate of the pose on the map; the robot does not move. An error, and nothing is sent, if a
  /// number is not finite; an error if the driver refuses the covariance.
  Result<void> set_pose(const Pose& pose, const Covariance& covariance);

  /// Requests all particles of the filter; none before its first step.
  Result<std::vector<Particle>> particles();

  Device& device() { return device_; }

 private:
  friend class Robot;
  explicit Localize(Device device) : device_(std::move(device)) {}

  Device device_;
};

}  // namespace playhouse::client
