#pragma once

/// The .cfg driver "laserposeinterpolator": scans of a laser with the pose of the robot at their time (pose_stamp.h).

#include <cstddef>
#include <mutex>
#include <optional>
#include <vector>

#include "playhouse/drivers/algorithm/forwarder.h"
#include "playhouse/drivers/definition.h"
#include "playhouse/drivers/scans/pose_stamp.h"

namespace playhouse::drivers {

/// Uses the laser and the position2d.
class LaserPoseInterpolator final : public Forwarder {
 public:
  LaserPoseInterpolator(Shell& shell, const PoseStampOptions& options);

  void closed() override;
  void take_news(std::vector<device::Publication>& more) override;
  void rewound(const Moment& moment) override;

 private:
  static constexpr std::size_t kPosition = 1;  // used device

  std::optional<device::Publication> passed(device::Publication message) override;

  device::Subscription& states_;

  std::mutex mutex_;  // guards what follows
  PoseStamp stamp_;
};

extern const DriverDefinition kLaserPoseInterpolatorDriver;

}  // namespace playhouse::drivers
