#include "playhouse/drivers/hardware/scanner_driver.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "playhouse/drivers/shapes.h"

namespace playhouse::drivers {

namespace lsr = wire::laser;
namespace rng = wire::ranger;

namespace {

/// Older programs ask in hundredths of a degree and in millimetres, and expect the answer in them.
constexpr double kHundredthOfDegree = std::numbers::pi / 18000;
bool asks_in_hundredths(const lsr::Config& asked) {
  return static_cast<double>(asked.resolution) > 2 * std::numbers::pi;
}
bool asks_in_millimetres(const lsr::Config& asked) {
  return asked.range_res >= 1;
}

bool is_finite(const ScanSettings& wanted) {
  for (const double value : {wanted.min_angle, wanted.max_angle, wanted.resolution, wanted.min_range,
                             wanted.max_range, wanted.range_res, wanted.frequency})
    if (!std::isfinite(value)) return false;
  return true;
}

}  // namespace

ScannerOptions read_scanner_options(SectionFields& fields, LinePlace place, const geom::Size& size) {
  ScannerOptions options{.hardware = read_hardware_options(fields, std::move(place), false)};
  const OptionText pose{"pose", "Of the scanner on the robot: x, y and heading."};
  options.X_RS.x = fields.length(pose, 0, SectionFields::kAnyNumber, 0);
  options.X_RS.y = fields.length(pose, 0, SectionFields::kAnyNumber, 1);
  options.X_RS.a = fields.angle(pose, 0, 2, SectionFields::kAnyNumber);
  const OptionText extent{"size", "Of the scanner: length and width."};
  options.size = size;
  options.size.x = fields.length(extent, size.x, 0, 0);
  options.size.y = fields.length(extent, size.y, 0, 1);
  options.is_upside_down =
      fields.flag({"invert", "1: it hangs upside down, and its scans are reversed."}, false);
  return options;
}

ScannerDriver::ScannerDriver(std::string name, Site& site, ScannerOptions options)
    : HardwareDriver(std::move(name), site, options.hardware), options_(std::move(options)) {
  register_laser();
  register_ranger();
}

// --- what clients ask

void ScannerDriver::register_laser() {
  on_question(kLaser, lsr::kReqGetGeom, [this]() -> AnswerBody {
    return wire::encode(lsr::Geom{pose3d(options_.X_RS), bbox3d(options_.size)});
  });
  on_question(kLaser, lsr::kReqGetConfig,
              [this]() -> AnswerBody { return wire::encode(laser_config(settings())); });
  on_request<lsr::Config>(kLaser, lsr::kReqSetConfig,
                          [this](const lsr::Config& asked) { return set_laser(asked); });
  on_request<lsr::PowerConfig>(kLaser, lsr::kReqPower, [this](const lsr::PowerConfig& asked) {
    return set_switch(&ScanSettings::power, asked.state != 0);
  });
}

void ScannerDriver::register_ranger() {
  on_question(kRanger, rng::kReqGetGeom, [this]() -> AnswerBody { return wire::encode(ranger_geometry()); });
  on_question(kRanger, rng::kReqGetConfig,
              [this]() -> AnswerBody { return wire::encode(ranger_config(settings())); });
  on_request<rng::Config>(kRanger, rng::kReqSetConfig,
                          [this](const rng::Config& asked) { return set_ranger(asked); });
  on_request<rng::PowerConfig>(kRanger, rng::kReqPower, [this](const rng::PowerConfig& asked) {
    return set_switch(&ScanSettings::power, asked.state != 0);
  });
  on_request<rng::IntnsConfig>(kRanger, rng::kReqIntns, [this](const rng::IntnsConfig& asked) {
    return set_switch(&ScanSettings::intensity, asked.state != 0);
  });
}

/// 0 leaves a value as it is. The range follows from its resolution in some scanners, so that it is not asked for.
AnswerBody ScannerDriver::set_laser(const lsr::Config& asked) {
  ScanSettings wanted = settings();
  wanted.min_angle = static_cast<double>(asked.min_angle);
  wanted.max_angle = static_cast<double>(asked.max_angle);
  if (asked.resolution != 0) wanted.resolution = laser_resolution(asked.resolution);
  if (asked.range_res != 0) wanted.range_res = static_cast<double>(asked.range_res);
  if (asks_in_millimetres(asked)) wanted.range_res /= 1000;
  if (asked.scanning_frequency != 0) wanted.frequency = static_cast<double>(asked.scanning_frequency);
  wanted.intensity = asked.intensity != 0;
  if (!is_finite(wanted) || !configure(wanted)) return std::nullopt;
  lsr::Config now = laser_config(settings());
  if (asks_in_hundredths(asked))
    now.resolution = static_cast<float>(std::round(settings().resolution / kHundredthOfDegree));
  if (asks_in_millimetres(asked)) now.range_res = static_cast<float>(1000 * settings().range_res);
  return wire::encode(now);
}

AnswerBody ScannerDriver::set_ranger(const rng::Config& asked) {
  ScanSettings wanted = settings();
  wanted.min_angle = asked.min_angle;
  wanted.max_angle = asked.max_angle;
  if (asked.angular_res != 0) wanted.resolution = asked.angular_res;
  if (asked.range_res != 0) wanted.range_res = asked.range_res;
  if (asked.frequency != 0) wanted.frequency = asked.frequency;
  if (!is_finite(wanted) || !configure(wanted)) return std::nullopt;
  return wire::encode(ranger_config(settings()));
}

AnswerBody ScannerDriver::set_switch(bool ScanSettings::*which, bool on) {
  ScanSettings wanted = settings();
  wanted.*which = on;
  return configure(wanted) ? done() : std::nullopt;
}

// --- scans

void ScannerDriver::publish_scan(LineScan scan) {
  if (options_.is_upside_down) {
    std::ranges::reverse(scan.ranges);
    std::ranges::reverse(scan.intensities);
  }
  ++scans_;
  publish_laser(scan);
  publish_ranger(scan);
}

void ScannerDriver::publish_laser(const LineScan& scan) {
  if (!is_open(kLaser)) return;
  const ScanSettings& now = settings();
  publish(kLaser, lsr::kDataScan,
          lsr::Data{static_cast<float>(now.min_angle), static_cast<float>(now.max_angle),
                    static_cast<float>(now.resolution), static_cast<float>(now.max_range), scan.ranges,
                    scan.intensities, scans_});
}

void ScannerDriver::publish_ranger(const LineScan& scan) {
  if (!is_open(kRanger)) return;
  const rng::DataRange ranges{{scan.ranges.begin(), scan.ranges.end()}};
  const rng::DataIntns intensities{{scan.intensities.begin(), scan.intensities.end()}};
  if (std::exchange(is_new_, false))
    publish(kRanger, rng::kDataRangestamped,
            rng::DataRangestamped{ranges, 1, ranger_geometry(), 1, ranger_config(settings())});
  publish(kRanger, rng::kDataRange, ranges);
  if (!scan.intensities.empty()) publish(kRanger, rng::kDataIntns, intensities);
}

rng::Geom ScannerDriver::ranger_geometry() const {
  return {pose3d(options_.X_RS), bbox3d(options_.size), {wire::Pose3d{}}, {bbox3d(options_.size)}};
}

// --- for emulators

std::size_t beam_at(const lsr::Data& scan, double angle) {
  constexpr double kTurn = 2 * std::numbers::pi;
  constexpr double kTolerance = 0.01;  // of the step between two beams
  const std::size_t count = scan.ranges.size();
  const auto first = static_cast<double>(scan.min_angle);
  const double step = count > 1
                          ? (static_cast<double>(scan.max_angle) - first) / static_cast<double>(count - 1)
                          : static_cast<double>(scan.resolution);
  if (count == 0 || !(step > 0) || !std::isfinite(first)) return count;
  for (const double turned : {angle, angle - kTurn, angle + kTurn}) {
    const double at = (turned - first) / step;
    if (at >= -0.5 - kTolerance && at <= static_cast<double>(count) - 0.5 + kTolerance)
      return std::min(count - 1, static_cast<std::size_t>(std::lround(std::max(0.0, at))));
  }
  return count;
}

BeamEcho echo_at(const lsr::Data& scan, double angle) {
  const std::size_t beam = beam_at(scan, angle);
  if (beam == scan.ranges.size()) return {};
  BeamEcho echo{.is_seen = true, .range = static_cast<double>(scan.ranges[beam])};
  echo.is_hit = scan.ranges[beam] >= 0 && scan.ranges[beam] < scan.max_range;
  if (beam < scan.intensity.size()) echo.intensity = scan.intensity[beam];
  return echo;
}

}  // namespace playhouse::drivers
