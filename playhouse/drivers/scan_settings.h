#pragma once

/// What clients may set of a scan: a device reports every n-th beam of a part of what its model measures, every
/// n-th time, and shortens ranges. Values.

#include <cstdint>
#include <optional>

#include "playhouse/wire/generated/laser.h"
#include "playhouse/wire/generated/ranger.h"

namespace playhouse::drivers {

struct ScanSettings {
  double min_angle = 0, max_angle = 0;  // rad, of the first and the last beam
  double resolution = 0;                // rad, between neighbouring beams
  double min_range = 0, max_range = 0;  // m
  double range_res = 0;                 // m
  double frequency = 0;                 // Hz
  bool power = true, intensity = true;
};

/// What a model measures.
struct ScanSource {
  ScanSettings usual;
  std::uint32_t beams = 0;         // evenly spaced; 0: of an array, whose directions are given
  std::uint64_t update_ticks = 1;  // between two scans
};

/// Which of that is reported.
struct ScanChoice {
  std::uint32_t first = 0, stride = 1, count = 0;  // beams
  std::uint64_t every = 1;                         // scans
  bool all = true;                                 // every beam, with the ranges as measured

  bool is_due(const ScanSource& source, std::uint64_t tick) const {
    return tick / source.update_ticks % every == 0;
  }
};

/// True for values of which one may have been a float32 on the way.
bool is_same(double a, double b);

/// Turns what is wanted into what is possible: beams of the source within the wanted angles, no coarser than wanted,
/// and scans no rarer than wanted. None if a value is not finite, or beyond what the source measures: a
/// wider field of view, finer or more frequent scans, a longer range, a shorter minimum range.
std::optional<ScanChoice> choose(const ScanSource& source, ScanSettings& wanted);

/// What a laser and a ranger tell of settings.
wire::laser::Config laser_config(const ScanSettings& settings);
wire::ranger::Config ranger_config(const ScanSettings& settings);

/// The resolution of a request to a laser.  [rad] Older programs, and the test program of libplayerc++, send hundredths
/// of a degree, which are more than a full turn if they are read as radians.
double laser_resolution(float resolution);

/// A measured range as settings have it: in whole steps of another range_res than the usual one, and between min_range
/// and max_range; of an array, between those that are not as usual.
double shown_range(const ScanSource& source, const ScanSettings& settings, double range);

}  // namespace playhouse::drivers
