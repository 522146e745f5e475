#pragma once

/// DueList: which sensors of a table measure in a tick:
/// those that are subscribed and whose period has elapsed.

#include <cstdint>
#include <span>
#include <vector>

#include "playhouse/world/world.h"

namespace playhouse::behaviour {

/// The columns of a sensor table that schedule measurements, whatever is measured.
struct SensorTable {
  std::span<const world::ModelRow> model;  // (sensors)
  std::span<std::uint64_t> measured_tick;  // of the latest measurement; 0: none yet (sensors)
};

class DueList {
 public:
  /// Reads the periods of all sensors. To be called again when the population has changed.
  void populate(const world::World& world, std::span<const world::ModelRow> models);

  /// The rows due at `tick`, in order; sets their
  /// measured_tick. Valid until the next call.
  std::span<const world::KindRow> take(const world::World& world, SensorTable table, std::uint64_t tick);

 private:
  std::vector<std::uint64_t> period_;  // ticks between two measurements (rows of SceneDesc::models)
  std::vector<world::KindRow> due_;
};

}  // namespace playhouse::behaviour
