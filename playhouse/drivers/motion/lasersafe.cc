#include "playhouse/drivers/motion/lasersafe.h"

#include <cmath>
#include <utility>

#include "playhouse/base/log.h"
#include "playhouse/drivers/decoded.h"
#include "playhouse/geom/trig.h"
#include "playhouse/wire/codec.h"
#include "playhouse/wire/generated/position2d.h"

namespace playhouse::drivers {

bool is_blocked(const LaserSafeOptions& options, double half_width, const wire::laser::Data& scan) {
  for (std::size_t i = 0; i < scan.ranges.size(); i += static_cast<std::size_t>(options.step)) {
    const double range = scan.ranges[i];
    if (!(range >= 0 && range < 1e9)) continue;  // no echo
    if (!options.is_box) {
      if (range < options.distance) return true;
      continue;
    }
    const double angle =
        static_cast<double>(scan.min_angle) + static_cast<double>(i) * static_cast<double>(scan.resolution);
    if (!std::isfinite(angle)) return true;  // it may be anywhere
    const geom::SinCos heading = geom::sincos(geom::normalize(angle));
    if (range * heading.cos < options.distance && std::fabs(range * heading.sin) < half_width) return true;
  }
  return false;
}

LaserSafe::LaserSafe(Shell& shell, const LaserSafeOptions& options)
    : PositionGuard(shell), options_(options), scans_(shell.client().queue(kLaser, kStatesKept)) {}

void LaserSafe::opened() {
  {
    const std::lock_guard lock(mutex_);
    ranges_.clear();
    blocked_ = true;
    half_width_.reset();
    if (options_.width >= 0 || !options_.is_box) half_width_ = options_.width / 2;
    if (half_width_) return;
  }
  shell_.client().ask(kForwarded, wire::position2d::kReqGetGeom, {}, [this](const AnswerBody& body) {
    const auto geom = decoded<wire::position2d::Geom>(body);
    if (!geom || !(geom->size.sw > 0 && geom->size.sw < 1e9))
      return log::warn(
          "driver lasersafe: its robot does not tell its width, so it does not let it drive: set boxwidth");
    const std::lock_guard lock(mutex_);
    half_width_ = geom->size.sw * (1 + options_.width_margin) / 2;
  });
}

void LaserSafe::take_news(std::vector<device::Publication>& more) {
  Forwarder::take_news(more);
  for (const device::Publication& message : scans_.take()) {
    if (message.subtype != wire::laser::kDataScan) continue;
    if (Result<wire::laser::Data> scan = wire::decode<wire::laser::Data>(message.body))
      take_scan(std::move(*scan));
  }
  look_again();
}

void LaserSafe::take_scan(wire::laser::Data scan) {
  const std::lock_guard lock(mutex_);
  if (!ranges_.empty() && ranges_.back().size() != scan.ranges.size()) ranges_.clear();
  ranges_.push_back(scan.ranges);
  while (ranges_.size() > static_cast<std::size_t>(options_.history)) ranges_.pop_front();
  for (std::size_t i = 0; i < scan.ranges.size(); ++i) {
    float sum = 0;
    for (const std::vector<float>& each : ranges_) sum += each[i];
    scan.ranges[i] = sum / static_cast<float>(ranges_.size());
  }
  blocked_ = !half_width_ || is_blocked(options_, *half_width_, scan);
}

bool LaserSafe::forbids(const CommandedMotion& motion) const {
  if (!blocked_) return false;
  return motion.to_goal || (options_.looks_ahead ? motion.ahead > 0 : motion.ahead < 0);
}

Result<LaserSafeOptions> laser_safe_options(SectionFields fields) {
  LaserSafeOptions options;
  options.distance =
      fields.length({"safedistance", "Of the laser from the nearest obstacle."}, options.distance, 0);
  options.step = fields.integer({"step", "Every so many beams count."}, options.step, 1, 1000);
  options.history =
      fields.integer({"history", "A range is its mean over so many scans."}, options.history, 1, 100);
  options.looks_ahead = fields.flag(
      {"forward", "1: the laser looks ahead, and the robot may back away; 0: it looks to the back."},
      options.looks_ahead);
  options.is_box = fields.flag(
      {"boxmode", "1: what is beside a box before the laser is no obstacle; 0: all within the distance are."},
      options.is_box);
  options.width = fields.length({"boxwidth", "Of the box; below 0: that of the robot and boxsafety."},
                                options.width, SectionFields::kAnyNumber);
  options.width_margin = fields.number(
      {"boxsafety", "The box is wider than the robot by this part of its width."}, options.width_margin);
  if (const Result<void> fault = fields.fault(); !fault) return fault.error();
  return options;
}

namespace {

Result<std::unique_ptr<device::Driver>> make_laser_safe(const config::CfgSection& section, Site& site) {
  return make_algorithm<LaserSafe>(
      section, site, {.provides = {{"position2d"}}, .uses = {{"position2d"}, {"laser"}}}, laser_safe_options);
}

constexpr DeviceText kLaserSafeProvides[] = {{"position2d"}};
constexpr DeviceText kLaserSafeUses[] = {{"position2d", {}, HowMany::kOne, "is the robot"},
                                         {"laser", {}, HowMany::kOne, "is on the robot"}};

}  // namespace

constinit const DriverDefinition kLaserSafeDriver{
    .name = "lasersafe",
    .doc = "Keeps a robot from driving into what its laser sees; it may back away.",
    .provides = kLaserSafeProvides,
    .uses = kLaserSafeUses,
    .read_options = reading<laser_safe_options>,
    .make = make_laser_safe,
};

}  // namespace playhouse::drivers
