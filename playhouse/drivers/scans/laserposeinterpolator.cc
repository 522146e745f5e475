#include "playhouse/drivers/scans/laserposeinterpolator.h"

#include <utility>

#include "playhouse/drivers/decoded.h"
#include "playhouse/drivers/shapes.h"
#include "playhouse/wire/codec.h"
#include "playhouse/wire/generated/laser.h"
#include "playhouse/wire/generated/position2d.h"

namespace playhouse::drivers {

LaserPoseInterpolator::LaserPoseInterpolator(Shell& shell, const PoseStampOptions& options)
    : Forwarder(shell), states_(shell.client().queue(kPosition, kStatesKept)), stamp_(options) {}

void LaserPoseInterpolator::closed() {
  const std::lock_guard lock(mutex_);
  stamp_.clear();
}

void LaserPoseInterpolator::rewound(const Moment&) {
  const std::lock_guard lock(mutex_);
  stamp_.clear();
}

void LaserPoseInterpolator::take_news(std::vector<device::Publication>& more) {
  for (const device::Publication& message : states_.take()) {
    if (message.subtype != wire::position2d::kDataState) continue;
    const Result<wire::position2d::Data> state = wire::decode<wire::position2d::Data>(message.body);
    const std::lock_guard lock(mutex_);
    if (state && is_usable(state->pos)) stamp_.add(message.timestamp, pose_of(state->pos));
  }
  Forwarder::take_news(more);
}

std::optional<device::Publication> LaserPoseInterpolator::passed(device::Publication message) {
  if (message.subtype != wire::laser::kDataScan) return std::nullopt;
  Result<wire::laser::Data> scan = wire::decode<wire::laser::Data>(message.body);
  if (!scan) return std::nullopt;
  const std::lock_guard lock(mutex_);
  const std::optional<geom::Pose> X_OR = stamp_.stamp(message.timestamp);
  if (!X_OR) return std::nullopt;
  message.subtype = wire::laser::kDataScanpose;
  message.body = wire::encode(wire::laser::DataScanpose{std::move(*scan), pose2d(*X_OR)});
  return message;
}

namespace {

Result<std::unique_ptr<device::Driver>> make_laser_pose_interpolator(const config::CfgSection& section,
                                                                     Site& site) {
  return make_algorithm<LaserPoseInterpolator>(
      section, site, {.provides = {{"laser"}}, .uses = {{"laser"}, {"position2d"}}}, pose_stamp_options);
}

constexpr DeviceText kLaserPoseInterpolatorProvides[] = {{"laser"}};
constexpr DeviceText kLaserPoseInterpolatorUses[] = {{"laser", {}, HowMany::kOne, "has the scans"},
                                                     {"position2d", {}, HowMany::kOne, "has the poses"}};

}  // namespace

constinit const DriverDefinition kLaserPoseInterpolatorDriver{
    .name = "laserposeinterpolator",
    .doc = "A laser whose scans tell the pose of the robot at their time.",
    .provides = kLaserPoseInterpolatorProvides,
    .uses = kLaserPoseInterpolatorUses,
    .read_options = reading<pose_stamp_options>,
    .make = make_laser_pose_interpolator,
};

}  // namespace playhouse::drivers
