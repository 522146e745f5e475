#pragma once

/// The .cfg driver "differential": two wheels as a robot that steers by their difference.
///
/// In: velocities of the left and the right wheel over the ground, and how far they are apart.
///
/// Out: forward (left + right) / 2, turning left (right - left) / distance; the pose, a chain of arcs of constant velocity.

#include <array>
#include <cstddef>
#include <mutex>
#include <optional>
#include <vector>

#include "playhouse/base/result.h"
#include "playhouse/drivers/algorithm/shell.h"
#include "playhouse/drivers/definition.h"
#include "playhouse/drivers/section_fields.h"
#include "playhouse/geom/pose.h"
#include "playhouse/wire/generated/position1d.h"
#include "playhouse/wire/generated/position2d.h"

namespace playhouse::drivers {

struct WheelSpeeds {
  double left = 0, right = 0;  // m/s
};

/// `apart`: of the wheels [m].
WheelSpeeds wheel_speeds(const geom::Twist& body, double apart);
geom::Twist body_velocity(const WheelSpeeds& wheels, double apart);
/// Along an arc.
geom::Pose moved_along(const geom::Pose& X_OR, const geom::Twist& body, double seconds);

struct DifferentialOptions {
  double apart = 0.25;  // m
};

Result<DifferentialOptions> differential_options(SectionFields fields);

/// Uses the left wheel and the right one. Between two of their data their velocities are those of the earlier one.
class Differential final : public Algorithm {
 public:
  Differential(Shell& shell, const DifferentialOptions& options);

  void closing() override;
  void closed() override;
  void take_news(std::vector<device::Publication>& more) override;

 private:
  static constexpr std::size_t kLeft = 0, kRight = 1;  // used devices

  device::Taken drive(const wire::position2d::CmdVel& command);
  void tell_wheels(const WheelSpeeds& speeds, std::uint8_t state);
  void switch_motors(const device::Message& message, device::Replier replier);
  void set_pose(const geom::Pose& X_OR);
  bool take_wheel(std::size_t wheel, const device::Publication& message);
  WheelSpeeds measured() const;

  Shell& shell_;
  const DifferentialOptions options_;
  std::array<device::Subscription*, 2> data_;

  std::mutex mutex_;  // guards what follows
  std::array<wire::position1d::Data, 2> wheels_;
  std::optional<double> time_;  // s; of the newest data
  geom::Pose X_OR_;
  bool drives_ = false;
};

extern const DriverDefinition kDifferentialDriver;

}  // namespace playhouse::drivers
