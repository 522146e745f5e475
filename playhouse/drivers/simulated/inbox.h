#pragma once

/// Inbox: hand-over 1, from the io thread to the tick thread. Commands are latest-value slots, one per
/// robot; everything else is a bounded queue of changes. What one robot is told arrives in the order it was
/// said: a change of a robot closes its slot, so a command before it is carried out before it, and a later
/// one after it.

#include <array>
#include <cstddef>
#include <functional>
#include <map>
#include <mutex>
#include <variant>
#include <vector>

#include "playhouse/world/world.h"

namespace playhouse::drivers {

/// What a robot's wheels are told. A newer one replaces an older one that the tick has not taken yet.
struct PositionCommand {
  enum class Kind : std::uint8_t { kVelocity, kGoal, kHeading };
  world::ModelId robot;
  Kind kind = Kind::kVelocity;
  /// kVelocity: x, y [m/s], turn [rad/s]; kGoal: x, y [m], heading [rad] in X_OM's frame; kHeading: speed
  /// [m/s], nothing, heading [rad] in X_OM's frame. Finite.
  std::array<double, 3> value{};
};

using Change = std::function<void(world::World&)>;

class Inbox {
 public:
  using Entry = std::variant<PositionCommand, Change>;

  /// Replaces the robot's waiting command, or waits as a new one.
  void command(const PositionCommand& command);

  /// False when limits::kRequestQueue changes are waiting, or after close(); nothing is taken then. `robot`,
  /// if any, is whom the change concerns.
  bool post(Change change, world::ModelId robot = {});

  /// As post(), for a change that concerns every robot.
  bool post_to_all(Change change);

  /// As post(), and refused after close() only: for what must not be lost and is bounded by its sender (the
  /// close of a device).
  void post_always(Change change, world::ModelId robot = {});

  /// Moves everything that waits to `out` (cleared first), in order.
  void take(std::vector<Entry>& out);

  bool empty() const;

  /// Nobody will take what is posted from now on: it is refused. What waits stays for take().
  void close();
  bool closed() const;

 private:
  void append(Change change, world::ModelId robot);

  mutable std::mutex mutex_;
  std::vector<Entry> entries_;
  std::map<world::ModelId, std::size_t> slots_;  // of robots with an open command: where it is in entries_
  std::size_t changes_ = 0;
  bool closed_ = false;
};

}  // namespace playhouse::drivers
