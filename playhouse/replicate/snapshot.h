#pragma once

/// Snapshot: the quantised state of one tick, copied from the world while that stands between two ticks, and
/// read by the thread that serves viewers. Only hot columns, and only the sensors that somebody looks at.
/// Buffers are reused: after the first captures nothing is allocated.

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "playhouse/replicate/layout.h"
#include "playhouse/replicate/views.h"
#include "playhouse/world/control.h"

namespace playhouse::replicate {

/// What all viewers together look at.
struct Interest {
  geom::Box view;                        // sensors of robots in here are captured  [m, W]; empty: none
  std::vector<world::ModelId> selected;  // ascending: of their robots, everything is captured
};

/// One sensor's scan: beams[first .. first + layout.sensors[sensor].beam_count).
struct Scan {
  std::uint32_t sensor = 0;  // row
  std::uint32_t first = 0;
};

/// What a view says of one model: values[first .. first + count).
struct Viewed {
  std::uint32_t view = 0;   // of views()
  std::uint32_t model = 0;  // row
  std::uint32_t first = 0, count = 0;
};

/// What a model says.
struct Said {
  std::uint32_t model = 0;  // row
  std::string text;
};

struct Snapshot {
  std::shared_ptr<const Layout> layout;  // whose rows the others are
  std::uint64_t tick = 0;
  world::Pace pace;
  std::vector<ModelState> models;
  std::vector<Scan> scans;  // by sensor row
  std::vector<std::uint16_t> beams;
  std::vector<Viewed> viewed;  // by view and model row
  std::vector<std::int32_t> values;
  std::vector<Said> says;   // by model row: those that say something
  std::uint64_t said = 0;   // World::said() when they did
  bool beams_full = false;  // limits::kSnapshotBeams was reached; the rest of the sensors is left out
};

/// Copies the world's state. `layout` is of its present population. A sensor is captured when it measures (it
/// has subscribers and a first scan) and its robot is selected or in view; selected robots come first when
/// there is no room for all. Thread: any, between steps. Cost O(models + beams captured), and texts only
/// when somebody has said something since the last capture into `out`.
void capture(const world::World& world, const world::Pace& pace, std::shared_ptr<const Layout> layout,
             const Interest& interest, Snapshot& out);

/// Where the top-level model of `row` stands in the snapshot. [m, W]
geom::Vec2 place_of(const Snapshot& snapshot, std::uint32_t row);

}  // namespace playhouse::replicate
