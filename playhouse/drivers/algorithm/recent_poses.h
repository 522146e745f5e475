#pragma once

/// RecentPoses: where a robot was at a time, as that of a scan, from the poses that it was told.

#include <cstddef>
#include <deque>
#include <optional>

#include "playhouse/geom/pose.h"

namespace playhouse::drivers {

class RecentPoses {
 public:
  static constexpr std::size_t kKept = 64;

  /// A time before the last one begins anew.
  void add(double time, const geom::Pose& pose);
  /// Between two poses in proportion to the time. At a time of which it knows nothing, as of a device with another
  /// clock, it is the newest pose; none if there is none.
  std::optional<geom::Pose> at(double time) const;

 private:
  struct Timed {
    double time = 0;  // s
    geom::Pose pose;
  };
  std::deque<Timed> poses_;  // the newest last
};

}  // namespace playhouse::drivers
