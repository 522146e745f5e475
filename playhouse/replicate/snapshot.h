#pragma once

/// Snapshot: the quantised state of one tick, copied from the world on the tick thread and read by the thread
/// that serves viewers. Only hot columns, and only the sensors that somebody looks at. Buffers are reused:
/// after the first captures nothing is allocated.

#include <cstdint>
#include <vector>

#include "playhouse/replicate/layout.h"
#include "playhouse/world/control.h"

namespace playhouse::replicate {

/// What all viewers together look at.
struct Interest {
  geom::Box view;                       // sensors of robots in here are captured  [m, W]; empty: none
  std::vector<std::uint32_t> selected;  // top-level rows, ascending: all their sensors are captured
};

/// A selected robot's own view.
struct Placed {
  std::uint32_t position = 0;  // row
  PositionState state;
};

/// One sensor's scan: beams[first .. first + layout.sensors[sensor].beam_count).
struct Scan {
  std::uint32_t sensor = 0;
  std::uint32_t first = 0;
};

struct HitState {
  std::uint32_t target = 0;  // model row
  std::int32_t id = 0;
  std::int32_t range = 0;                  // mm
  std::uint16_t bearing = 0, heading = 0;  // 1/65536 turn
  friend bool operator==(const HitState&, const HitState&) = default;
};

/// What one fiducial finder sees: hits[first .. first + count).
struct Finding {
  std::uint32_t finder = 0;
  std::uint32_t first = 0, count = 0;
};

struct Snapshot {
  std::uint64_t tick = 0;
  world::Pace pace;
  std::vector<ModelState> models;
  std::vector<Placed> positions;  // of the selected robots, by robot
  std::vector<Scan> scans;        // by sensor row
  std::vector<std::uint16_t> beams;
  std::vector<Finding> findings;  // by finder row
  std::vector<HitState> hits;
  bool beams_full = false;  // limits::kSnapshotBeams was reached; the rest of the sensors is left out
};

/// Copies the world's state. A sensor is captured when it measures (it has subscribers and a first scan) and
/// its robot is selected or in view; selected robots come first when there is no room for all. Thread: tick,
/// between steps. Cost O(models + beams captured).
void capture(const world::World& world, const world::Pace& pace, const Layout& layout,
             const Interest& interest, Snapshot& out);

/// Where the top-level model of `row` stands in the snapshot. [m, W]
geom::Vec2 place_of(const Layout& layout, const Snapshot& snapshot, std::uint32_t row);

}  // namespace playhouse::replicate
