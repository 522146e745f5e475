#include "playhouse/drivers/algorithm/recent_poses.h"

#include <algorithm>

namespace playhouse::drivers {

void RecentPoses::add(double time, const geom::Pose& pose) {
  if (!poses_.empty() && time < poses_.back().time) poses_.clear();
  poses_.push_back({time, pose});
  if (poses_.size() > kKept) poses_.pop_front();
}

std::optional<geom::Pose> RecentPoses::at(double time) const {
  if (poses_.empty()) return std::nullopt;
  const auto after = std::ranges::upper_bound(poses_, time, {}, &Timed::time);
  if (after == poses_.begin() || after == poses_.end()) return poses_.back().pose;
  const Timed &a = *std::prev(after), &b = *after;
  const double share = (time - a.time) / (b.time - a.time);
  const geom::Vec2 p = a.pose.xy() + share * (b.pose.xy() - a.pose.xy());
  return geom::Pose{p.x, p.y, a.pose.z,
                    geom::normalize(a.pose.a + share * geom::normalize(b.pose.a - a.pose.a))};
}

}  // namespace playhouse::drivers
