#pragma once

/// Gripper with two fingers. SI units and radians.

#include <cstdint>
#include <optional>

#include "playhouse/wire/generated/gripper.h"
#include "playhouse_client/client.h"
#include "playhouse_client/pose.h"

namespace playhouse::client {

/// State of the fingers. `closed` is as far as possible, perhaps around an object; none of the three is set
/// if they are faulty, or stopped in between.
struct GripperState {
  bool open = false, closed = false, moving = false;
  std::uint32_t beams =
      0;            // a bit per break beam, set if interrupted; simulated: 4 the inner, 8 the outer one
  double time = 0;  // the server's, of these data [s]
};

struct GripperGeometry {
  Pose3d pose;  // on the robot
  Size size;
  Size gap;  // between the open fingers
  std::uint32_t beam_count = 0;
};

/// A simulated gripper holds what is between its fingers when they close, and moves while its device is open.
class Gripper {
 public:
  static Result<Gripper> open(Client& client, std::uint16_t index, Access access = Access::kAll);

  /// The newest state; none before the first data.
  std::optional<GripperState> state() const;

  Result<void> open_fingers();
  Result<void> close_fingers();
  /// Stops the fingers where they are.
  Result<void> stop();

  Result<GripperGeometry> geometry();

  Device& device() { return device_; }

 private:
  friend class Robot;
  explicit Gripper(Device device) : device_(std::move(device)) {}

  Device device_;
};

}  // namespace playhouse::client
