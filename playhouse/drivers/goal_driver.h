#pragma once

/// GoalDriver: base of drivers that drive a robot to goals, a position2d in front of others. Goals are
/// handled by steps of the subclass on a thread of its own; everything else is forwarded. The input gives the
/// pose, the output gets velocities and requests; they may be one device.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "playhouse/base/result.h"
#include "playhouse/device/client.h"
#include "playhouse/device/driver.h"
#include "playhouse/drivers/algorithm_thread.h"
#include "playhouse/drivers/site.h"
#include "playhouse/geom/pose.h"
#include "playhouse/scene/cfg.h"
#include "playhouse/wire/generated/position2d.h"

namespace playhouse::drivers {

class GoalDriver : public device::Driver {
 public:
  /// Output and input are indices of the client's devices.
  GoalDriver(device::Opener& opener, std::size_t devices, std::size_t output, std::size_t input);

  void set_device(device::DeviceId device) { device_ = device; }
  device::DeviceClient& client() { return client_; }
  /// A subclass's last member, so that it is joined before what its steps use is destroyed.
  virtual AlgorithmThread& thread() = 0;

  Result<void> start(device::DeviceId device) override;
  void stop(device::DeviceId device) override;
  void retired(device::DeviceId) override { stop(device_); }
  /// The world was rewound: discards computed results, keeps the goal unless it starts again. Tick thread.
  void rewound(bool to_start);
  device::Taken command(const device::Message& message) override;
  void request(const device::Message& message, device::Replier replier) override;
  bool capable(device::DeviceId device, std::uint8_t type, std::uint8_t subtype) const override;
  void barrier(device::Replier replier) override { client_.barrier(std::move(replier)); }

 protected:
  /// What a step drives to and from.
  struct Trip {
    std::uint64_t drive = 0;  // number of the drive, which may have several goals
    geom::Pose X_OG;
    wire::position2d::Data state;  // latest of the input
  };
  /// How a step ends a drive.
  enum class End : std::uint8_t { kNot, kAtGoal, kStuck };

  /// Requests the geometry of the client's devices.
  virtual void ask_geometry() = 0;
  /// Posts a step if there are new scans.
  virtual void take_scans() = 0;
  /// True if a step can use the state.
  virtual bool is_usable_state(const wire::position2d::Data& state) const;
  /// Logs why it drives to no goals until it is opened again, and refuses the current one.
  void drives_to_none(std::string why);

  /// None without a goal or a state. With mutex_ held.
  std::optional<Trip> trip() const;
  /// Applies the result of a step, unless its drive has ended.
  void steer(const Trip& trip, double speed, double turn_rate, End end);

  device::DeviceClient client_;
  mutable std::mutex mutex_;  // guards what a subclass learns on other threads than its own, and what follows

 private:
  struct Goal {
    geom::Pose X_OG;
    std::uint64_t drive = 0;
  };
  bool set_goal(std::optional<geom::Pose> X_OG);
  void refuse(std::string why);
  void take_news(std::vector<device::Publication>& more);
  void take_state(device::Publication& message);
  void drive(double speed, double turn_rate);

  std::optional<Goal> goal_;
  std::uint64_t drives_ = 0;  // so far
  bool gave_up_ = false;      // the last goal, being stuck
  std::string refusal_;       // of the last goal (refusal.h); empty: none
  std::string incapable_;     // why it drives to no goals; empty: it does
  std::optional<wire::position2d::Data> state_;

  const std::size_t output_;
  device::Subscription& position_;
  device::DeviceId device_;
};

/// Registers a section's driver with its device and those that its client uses, the output first.
Result<std::unique_ptr<device::Driver>> add_goal_driver(const scene::CfgSection& section, Site& site,
                                                        std::unique_ptr<GoalDriver> driver,
                                                        device::Address device,
                                                        const std::vector<device::Address>& required);

}  // namespace playhouse::drivers
