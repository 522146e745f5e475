#pragma once

/// The .cfg driver "lasersafe": keeps a robot from driving into what its laser sees.

#include <cstddef>
#include <deque>
#include <optional>
#include <vector>

#include "playhouse/base/result.h"
#include "playhouse/drivers/definition.h"
#include "playhouse/drivers/motion/position_guard.h"
#include "playhouse/drivers/section_fields.h"
#include "playhouse/wire/generated/laser.h"

namespace playhouse::drivers {

struct LaserSafeOptions {
  double distance = 0.4;      // m, from the laser
  int step = 5;               // every so many beams count
  int history = 1;            // scans that a range is the mean of
  bool looks_ahead = true;    // else to the back
  bool is_box = true;         // else a half disc
  double width = -1;          // m, of the box; below 0: that of the robot, and a part of it more
  double width_margin = 0.1;  // that part
};

Result<LaserSafeOptions> laser_safe_options(SectionFields fields);

/// True if a scan, the mean of some, has an obstacle in the box or half disc. `half_width`: of the box [m].
bool is_blocked(const LaserSafeOptions& options, double half_width, const wire::laser::Data& scan);

/// Uses the robot and its laser. Drives towards where the laser looks are forbidden without a scan, and while there is
/// an obstacle.
class LaserSafe final : public PositionGuard {
 public:
  LaserSafe(Shell& shell, const LaserSafeOptions& options);

  void opened() override;
  void take_news(std::vector<device::Publication>& more) override;

 private:
  static constexpr std::size_t kLaser = 1;  // used device

  bool forbids(const CommandedMotion& motion) const override;
  void take_scan(wire::laser::Data scan);

  const LaserSafeOptions options_;
  device::Subscription& scans_;

  // Guarded by mutex_.
  std::deque<std::vector<float>> ranges_;  // of the last scans, the newest last
  std::optional<double> half_width_;       // m; once it is known
  bool blocked_ = true;
};

extern const DriverDefinition kLaserSafeDriver;

}  // namespace playhouse::drivers
