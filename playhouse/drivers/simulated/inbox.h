#pragma once

/// Inbox: hand-over 1, from the io thread to the tick thread. Commands are latest-value slots, one per
/// model and interface; everything else is a bounded queue of changes. What one model is told arrives in the
/// order it was said: a change of a model closes its slots, so a command before it is carried out before it,
/// and a later one after it.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <mutex>
#include <utility>
#include <vector>

#include "playhouse/world/world.h"

namespace playhouse::drivers {

using Change = std::function<void(world::World&)>;

class Inbox {
 public:
  /// Where a model's commands wait: each interface of it has a slot.
  struct Slot {
    world::ModelId model;
    std::uint16_t interf = 0;
    auto operator<=>(const Slot&) const = default;
  };

  /// Replaces the command that waits in the slot, or waits as a new one.
  void command(Slot slot, Change command);

  /// False when limits::kRequestQueue changes are waiting, or after close(); nothing is taken then. `model`,
  /// if any, is whom the change concerns.
  bool post(Change change, world::ModelId model = {});

  /// As post(), for a change that concerns every model.
  bool post_to_all(Change change);

  /// As post(), and refused after close() only: for what must not be lost and is bounded by its sender (the
  /// close of a device).
  void post_always(Change change, world::ModelId model = {});

  /// Moves everything that waits to `out` (cleared first), in order.
  void take(std::vector<Change>& out);

  bool empty() const;

  /// Nobody will take what is posted from now on: it is refused. What waits stays for take().
  void close();
  bool closed() const;

 private:
  void append(Change change, world::ModelId model);

  mutable std::mutex mutex_;
  std::vector<Change> entries_;
  std::map<Slot, std::size_t> slots_;  // those with a command that may be replaced: where it is in entries_
  std::size_t changes_ = 0;
  bool closed_ = false;
};

}  // namespace playhouse::drivers
