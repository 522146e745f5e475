#include "playhouse/drivers/scans/pose_stamp.h"

#include <cmath>

namespace playhouse::drivers {

void PoseStamp::add(double time, const geom::Pose& X_OR) {
  poses_.add(time, X_OR);
  newest_ = X_OR;
}

std::optional<geom::Pose> PoseStamp::stamp(double time) {
  const std::optional<geom::Pose> X_OR = options_.interpolates ? poses_.at(time) : newest_;
  if (!X_OR || !is_due(time, *X_OR)) return std::nullopt;
  last_ = {time, *X_OR};
  return X_OR;
}

void PoseStamp::clear() {
  poses_ = {};
  newest_.reset();
  last_.reset();
}

/// The first one is, and the first one after the time went back.
bool PoseStamp::is_due(double time, const geom::Pose& X_OR) const {
  if (options_.all || !last_ || time < last_->time) return true;
  const geom::Vec2 moved = X_OR.xy() - last_->X_OR.xy();
  const double turned = std::fabs(geom::normalize(X_OR.a - last_->X_OR.a));
  return (options_.seconds >= 0 && time - last_->time >= options_.seconds) ||
         (options_.distance >= 0 && std::sqrt(geom::dot(moved, moved)) >= options_.distance) ||
         (options_.angle >= 0 && turned >= options_.angle);
}

Result<PoseStampOptions> pose_stamp_options(SectionFields fields) {
  constexpr double kAny = SectionFields::kAnyNumber;
  PoseStampOptions options;
  options.interpolates = fields.flag(
      {"interpolate", "1: the pose is that of the time of the scan, between two poses; 0: the newest one."},
      options.interpolates);
  options.distance =
      fields.length({"update_thresh",
                     "A scan is published once the robot has moved or turned so far since the last "
                     "one that was; below 0 that does not matter."},
                    options.distance, kAny, 0);
  options.angle = fields.angle({"update_thresh"}, options.angle, 1, kAny);
  options.seconds = fields.number(
      {"update_interval", "And once so much time has passed; below 0 that does not matter.", "s"},
      options.seconds, kAny);
  options.all = fields.flag(
      {"send_all_scans", "1: every scan is published, whatever update_thresh and update_interval say."},
      options.all);
  if (const Result<void> fault = fields.fault(); !fault) return fault.error();
  return options;
}

}  // namespace playhouse::drivers
