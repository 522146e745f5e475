#pragma once

/// PoseStamp: which scans are published with the pose of their robot, and that pose, for "laserposeinterpolator" and
/// "rangerposeinterpolator".

#include <optional>

#include "playhouse/base/result.h"
#include "playhouse/drivers/algorithm/recent_poses.h"
#include "playhouse/drivers/section_fields.h"
#include "playhouse/geom/pose.h"

namespace playhouse::drivers {

struct PoseStampOptions {
  bool interpolates = true, all = true;
  // From the last scan that was published; below 0: no matter.
  double distance = -1, angle = -1, seconds = -1;  // m, rad, s
};

Result<PoseStampOptions> pose_stamp_options(SectionFields fields);

class PoseStamp {
 public:
  explicit PoseStamp(const PoseStampOptions& options) : options_(options) {}

  void add(double time, const geom::Pose& X_OR);
  /// Of a scan of that time; none if it is not to be published, or no pose is known.
  std::optional<geom::Pose> stamp(double time);
  void clear();

 private:
  struct Stamped {
    double time = 0;  // s
    geom::Pose X_OR;
  };
  bool is_due(double time, const geom::Pose& X_OR) const;

  const PoseStampOptions options_;
  RecentPoses poses_;
  std::optional<geom::Pose> newest_;
  std::optional<Stamped> last_;  // that was published
};

}  // namespace playhouse::drivers
