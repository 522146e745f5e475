#pragma once

/// Sources: the devices that somebody has open, and what they have to say after a tick. Many of them encode
/// on the engine's workers, into lists of their own, and the batch is the same to the byte for any number of
/// workers. Thread: the tick thread; emit() has its workers help.

#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

#include "playhouse/device/driver.h"
#include "playhouse/world/workers.h"
#include "playhouse/world/world.h"

namespace playhouse::drivers {

/// Something with data to publish after a tick: a simulated device that is open.
class Source {
 public:
  virtual ~Source() = default;
  /// Appends what is new in this tick's world, encoded. Called on any worker, while others emit: it may write
  /// what is its own and nothing else, and take no lock. The world stays as it is meanwhile.
  virtual void emit(const world::World& world, std::vector<device::Publication>& out) = 0;
};

class Sources {
 public:
  void add(std::shared_ptr<Source> source) { all_.push_back(std::move(source)); }
  void remove(const Source& source) {
    std::erase_if(all_, [&](const std::shared_ptr<Source>& each) { return each.get() == &source; });
  }
  std::size_t size() const { return all_.size(); }

  /// Appends what each has, in the order in which they were added.
  void emit(const world::World& world, world::Workers& workers, std::vector<device::Publication>& out);

 private:
  using Batch = std::vector<device::Publication>;
  void emit_range(const world::World& world, std::size_t range);
  void join(std::size_t ranges, Batch& out);

  std::vector<std::shared_ptr<Source>> all_;
  std::vector<Batch> parts_;  // of each range of sources; empty between calls
};

}  // namespace playhouse::drivers
