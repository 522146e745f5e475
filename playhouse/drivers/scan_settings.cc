#include "playhouse/drivers/scan_settings.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace playhouse::drivers {
namespace {

/// Of the distance of two beams, or of two scans: clients send float32, and round numbers for others.
constexpr double kTolerance = 0.02;
constexpr double kSame = 1e-6;  // relative, of two values of which one was a float32
constexpr double kRarest = 1e9;

bool has_numbers(const ScanSettings& wanted) {
  return std::isfinite(wanted.min_angle) && std::isfinite(wanted.max_angle) &&
         std::isfinite(wanted.resolution) && std::isfinite(wanted.min_range) &&
         std::isfinite(wanted.max_range) && std::isfinite(wanted.range_res) &&
         std::isfinite(wanted.frequency);
}

/// Beams of a source whose beams are evenly spaced.
bool choose_beams(const ScanSource& source, ScanSettings& wanted, ScanChoice& choice) {
  const ScanSettings& usual = source.usual;
  if (wanted.min_angle == usual.min_angle && wanted.max_angle == usual.max_angle &&
      wanted.resolution == usual.resolution)
    return true;  // whatever its numbers are
  const double last_beam = source.beams - 1, step = usual.resolution;
  const double from = (wanted.min_angle - usual.min_angle) / step,
               to = (wanted.max_angle - usual.min_angle) / step;
  const double stride = std::floor(wanted.resolution / step + kTolerance);
  if (from > to || from < -kTolerance || to > last_beam + kTolerance || stride < 1) return false;
  const double first = std::ceil(from - kTolerance), last = std::floor(to + kTolerance);
  if (first > last) return false;
  choice.first = static_cast<std::uint32_t>(first);
  choice.stride = static_cast<std::uint32_t>(std::min(stride, last_beam));
  choice.count = static_cast<std::uint32_t>(last - first) / choice.stride + 1;
  if (choice.first == 0 && choice.stride == 1 && choice.count == source.beams) {
    wanted.min_angle = usual.min_angle;
    wanted.max_angle = usual.max_angle;
    wanted.resolution = usual.resolution;
    return true;
  }
  wanted.min_angle = usual.min_angle + choice.first * step;
  wanted.max_angle = wanted.min_angle + (choice.count - 1) * (choice.stride * step);
  wanted.resolution = choice.stride * step;
  return true;
}

/// Directions that are given can only be confirmed.
bool keeps_beams(const ScanSource& source, ScanSettings& wanted) {
  const ScanSettings& usual = source.usual;
  if (!is_same(wanted.min_angle, usual.min_angle) || !is_same(wanted.max_angle, usual.max_angle) ||
      !is_same(wanted.resolution, usual.resolution))
    return false;
  wanted.min_angle = usual.min_angle;
  wanted.max_angle = usual.max_angle;
  wanted.resolution = usual.resolution;
  return true;
}

bool choose_ranges(const ScanSettings& usual, ScanSettings& wanted) {
  if (is_same(wanted.min_range, usual.min_range)) wanted.min_range = usual.min_range;
  if (is_same(wanted.max_range, usual.max_range)) wanted.max_range = usual.max_range;
  if (is_same(wanted.range_res, usual.range_res)) wanted.range_res = usual.range_res;
  return wanted.min_range >= usual.min_range && wanted.max_range <= usual.max_range &&
         wanted.min_range <= wanted.max_range &&
         (wanted.range_res == usual.range_res || wanted.range_res > 0);
}

bool choose_scans(const ScanSettings& usual, ScanSettings& wanted, ScanChoice& choice) {
  if (wanted.frequency <= 0) return false;
  const double every = std::floor(usual.frequency / wanted.frequency + kTolerance);
  if (every < 1 || every > kRarest) return false;
  choice.every = static_cast<std::uint64_t>(every);
  wanted.frequency = usual.frequency / every;
  return true;
}

}  // namespace

bool is_same(double a, double b) {
  return std::isfinite(a) && std::fabs(a - b) <= kSame * std::max(std::fabs(a), std::fabs(b));
}

std::optional<ScanChoice> choose(const ScanSource& source, ScanSettings& wanted) {
  ScanChoice choice;
  choice.count = source.beams;
  const bool can_choose = source.beams > 1 && source.usual.resolution > 0;
  if (!has_numbers(wanted) ||
      !(can_choose ? choose_beams(source, wanted, choice) : keeps_beams(source, wanted)) ||
      !choose_ranges(source.usual, wanted) || !choose_scans(source.usual, wanted, choice))
    return std::nullopt;
  const ScanSettings& usual = source.usual;
  choice.all = choice.count == source.beams && wanted.min_range == usual.min_range &&
               wanted.max_range == usual.max_range && wanted.range_res == usual.range_res;
  return choice;
}

wire::laser::Config laser_config(const ScanSettings& settings) {
  wire::laser::Config config;
  config.min_angle = static_cast<float>(settings.min_angle);
  config.max_angle = static_cast<float>(settings.max_angle);
  config.resolution = static_cast<float>(settings.resolution);
  config.max_range = static_cast<float>(settings.max_range);
  config.range_res = static_cast<float>(settings.range_res);
  config.intensity = settings.intensity ? 1 : 0;
  config.scanning_frequency = static_cast<float>(settings.frequency);
  return config;
}

wire::ranger::Config ranger_config(const ScanSettings& settings) {
  return {settings.min_angle, settings.max_angle, settings.resolution, settings.min_range,
          settings.max_range, settings.range_res, settings.frequency};
}

double laser_resolution(float resolution) {
  constexpr double kHundredth = std::numbers::pi / 18000;  // rad, of a degree
  const auto wanted = static_cast<double>(resolution);
  return wanted > 2 * std::numbers::pi ? wanted * kHundredth : wanted;
}

double shown_range(const ScanSource& source, const ScanSettings& settings, double range) {
  if (settings.range_res != source.usual.range_res)
    range = settings.range_res * std::round(range / settings.range_res);
  // The usual limits are those of the first sensor of an array: the others have their own.
  const bool is_one = source.beams > 0;
  if (is_one || settings.min_range != source.usual.min_range) range = std::max(range, settings.min_range);
  if (is_one || settings.max_range != source.usual.max_range) range = std::min(range, settings.max_range);
  return range;
}

}  // namespace playhouse::drivers
