#pragma once

/// DueList: which sensors of a table measure in a tick: those that somebody subscribed and whose period is
/// over.

#include <cstdint>
#include <span>
#include <vector>

#include "playhouse/world/world.h"

namespace playhouse::behaviour {

/// The columns of a table of sensors that say when they measure, whatever they measure.
struct SensorTable {
  std::span<const world::ModelRow> model;  // (sensors)
  std::span<std::uint64_t> measured_tick;  // of the newest measurement; 0: none yet (sensors)
};

class DueList {
 public:
  /// Reads the periods of all sensors. To be called again when sensors came or went.
  void populate(const world::World& world, std::span<const world::ModelRow> models);

  /// The rows that measure for `tick`, in order; measured_tick says so from then on. Valid until the next
  /// call.
  std::span<const std::uint32_t> take(const world::World& world, SensorTable table, std::uint64_t tick);

 private:
  std::vector<std::uint64_t> period_;  // ticks between two measurements (rows of SceneDesc::models)
  std::vector<std::uint32_t> due_;
};

}  // namespace playhouse::behaviour
