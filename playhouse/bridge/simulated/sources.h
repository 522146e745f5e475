#pragma once

/// Sources: the open devices, which publish after a tick. Ranges of them
/// encode in parallel into separate lists; the batch is byte-identical for
/// any number of threads. Thread: the tick thread, unless stated otherwise.

#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

#include "playhouse/device/driver.h"
#include "playhouse/world/world.h"

namespace playhouse::drivers {

/// Publishes data after a tick: an open simulated device.
class DataSource {
 public:
  virtual ~DataSource() = default;
  /// Appends this tick's new data, encoded. Called on any thread, in parallel with others:
  /// it may write only its own state, and take no lock. The world does not change meanwhile.
  virtual void emit(const world::World& world, std::vector<device::Publication>& out) = 0;
};

class Sources {
 public:
  void add(std::shared_ptr<DataSource> source);
  void remove(const DataSource& source) {
    std::erase_if(all_, [&](const std::shared_ptr<DataSource>& each) { return each.get() == &source; });
  }
  std::size_t size() const { return all_.size(); }

  /// Number of ranges: call emit_range() for each.
  /// At most one if parallel encoding would not pay.
  std::size_t ranges() const;
  /// Any thread; ranges in parallel, but not during add() or remove().
  void emit_range(const world::World& world, std::size_t range);
  /// Appends the output of all ranges since the last call, in the order
  /// in which sources were added. Call it after all ranges are done.
  void join(std::vector<device::Publication>& out);

 private:
  using PublicationBatch = std::vector<device::Publication>;

  std::vector<std::shared_ptr<DataSource>> all_;
  std::vector<PublicationBatch> parts_;  // of each range, reused
};

}  // namespace playhouse::drivers
