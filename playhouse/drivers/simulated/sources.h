#pragma once

/// Sources: the devices that somebody has open, and what they have to say after a tick. Ranges of them encode
/// into lists of their own, on any threads, and the batch is the same to the byte whichever those are.
/// Thread: the tick thread, but for what is said otherwise.

#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

#include "playhouse/device/driver.h"
#include "playhouse/world/world.h"

namespace playhouse::drivers {

/// Something with data to publish after a tick: a simulated device that is open.
class Source {
 public:
  virtual ~Source() = default;
  /// Appends what is new in this tick's world, encoded. Called on any thread, while others emit: it may write
  /// what is its own and nothing else, and take no lock. The world stays as it is meanwhile.
  virtual void emit(const world::World& world, std::vector<device::Publication>& out) = 0;
};

class Sources {
 public:
  void add(std::shared_ptr<Source> source);
  void remove(const Source& source) {
    std::erase_if(all_, [&](const std::shared_ptr<Source>& each) { return each.get() == &source; });
  }
  std::size_t size() const { return all_.size(); }

  /// So many calls of emit_range(), for 0 and so on, make what all have. No more than one: it is not worth
  /// another thread.
  std::size_t ranges() const;
  /// Any thread; ranges at the same time, while add() and remove() are not called.
  void emit_range(const world::World& world, std::size_t range);
  /// Appends what all ranges made since the last call, in the order in which the sources were added. The
  /// thread that knows that they are done.
  void join(std::vector<device::Publication>& out);

 private:
  using Batch = std::vector<device::Publication>;

  std::vector<std::shared_ptr<Source>> all_;
  std::vector<Batch> parts_;  // of each range there ever was
};

}  // namespace playhouse::drivers
