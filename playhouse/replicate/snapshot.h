#pragma once

/// Snapshot: the quantised state of one tick, copied from the world between two ticks
/// and read by the thread that serves viewers. Only replicated columns, and only sensors
/// of interest. Buffers are reused: after the first captures nothing is allocated.

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "playhouse/replicate/layout.h"
#include "playhouse/replicate/views.h"
#include "playhouse/world/control.h"

namespace playhouse::replicate {

/// What is captured beyond the state of models.
struct Interest {
  geom::Box view;                        // sensors of robots in here are captured  [m, W]; empty: none
  std::vector<world::ModelId> selected;  // ascending; all sensors of their robots are captured

  /// Becomes the union of both.
  void add(const Interest& other);
  /// None; keeps its memory.
  void clear();
};

/// One sensor's scan: beams[first .. first + layout.sensors[sensor].beam_count).
struct SensorScan {
  world::SensorRow sensor;
  std::uint32_t first = 0;
};

/// A view of one model: values[first .. first + count).
struct Viewed {
  std::uint32_t view = 0;  // of views()
  world::ModelRow model;
  std::uint32_t first = 0, count = 0;
};

/// The text of a model.
struct Said {
  world::ModelRow model;
  std::string name, text;
};

/// A corner of a drawing, in the frame of its model.
struct SentCorner {
  std::int32_t x = 0, y = 0, z = 0;  // mm
  std::uint32_t color = 0;           // 0xRRGGBBAA
  std::uint8_t corners = 0;          // of its shape: 1, 2 or 3
  bool flat = false;                 // on the floor of the frame, where the newest shape covers older ones
  friend bool operator==(const SentCorner&, const SentCorner&) = default;
};
/// Shared by snapshots and replicas.
using SentDrawing = std::shared_ptr<const std::vector<SentCorner>>;

/// The drawing of a model.
struct ModelDrawing {
  world::ModelRow model;
  SentDrawing drawing;
};

struct Snapshot {
  std::shared_ptr<const Layout> layout;  // of the rows below
  std::uint64_t tick = 0;
  world::Pace pace;
  world::ByModel<ModelState> models;
  std::vector<SensorScan> scans;  // by sensor row
  std::vector<std::uint16_t> beams;
  std::vector<Viewed> viewed;  // by view and model row
  std::vector<std::int32_t> values;
  std::vector<Said> says;              // by model row; non-empty texts
  std::uint64_t said = 0;              // World::said() at the capture of `says`
  std::vector<ModelDrawing> drawings;  // by model row; non-empty
  std::uint64_t drawn = 0;             // World::drawn() at their capture
  bool beams_full = false;             // limits::kSnapshotBeams was reached; further sensors were dropped
};

/// Copies the world's state. `layout` is of its present population. A sensor is captured
/// if it is active (subscribed, with a first scan) and its robot is selected or in view;
/// selected robots first if room is short. Thread: any, between steps. Cost O(models +
/// beams captured); texts and drawings only if any has
/// changed since the last capture into `out`. Drawings that are as in `before`, another snapshot, are its objects.
void capture(const world::World& world, const world::Pace& pace, std::shared_ptr<const Layout> layout,
             const Interest& interest, Snapshot& out, const Snapshot* before = nullptr);

/// Position of the root in `row` in the snapshot. [m, W]
geom::Vec2 place_of(const Snapshot& snapshot, world::ModelRow row);

}  // namespace playhouse::replicate
