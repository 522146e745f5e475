#pragma once

/// The .cfg driver "nd": drives a robot to goals with obstacle avoidance by laser, sonar or both. A
/// position2d in front of others: goals are handled here (nd_step.h, on a thread of its own), everything else
/// is forwarded.

#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "playhouse/base/result.h"
#include "playhouse/device/client.h"
#include "playhouse/device/driver.h"
#include "playhouse/drivers/algorithm_thread.h"
#include "playhouse/drivers/decoded.h"
#include "playhouse/drivers/nd/nd_step.h"
#include "playhouse/drivers/site.h"
#include "playhouse/scene/cfg.h"
#include "playhouse/wire/generated/position2d.h"

namespace playhouse::drivers {

Result<std::unique_ptr<device::Driver>> make_nd(const scene::CfgSection& section, Site& site);

class Nd final : public device::Driver {
 public:
  /// Indices of the client's devices.
  struct Devices {
    std::size_t output = 0;                   // gets the velocities
    std::size_t input = 0;                    // gives the pose; may be the output
    std::optional<std::size_t> laser, sonar;  // one of them at least
    std::size_t count = 1;
  };

  /// Its client opens the devices while the device is open.
  Nd(device::Opener& opener, const Devices& devices, NdOptions options);

  void set_device(device::DeviceId device) { device_ = device; }
  device::Client& client() { return client_; }
  AlgorithmThread& thread() { return thread_; }

  std::string_view name() const override { return "nd"; }
  Result<void> start(device::DeviceId device) override;
  void stop(device::DeviceId device) override;
  void retired(device::DeviceId) override { stop(device_); }
  /// The world was rewound: discards computed results, keeps the goal unless it starts again. Tick thread.
  void rewound(bool to_start);
  device::Taken command(const device::Message& message) override;
  void request(const device::Message& message, device::Replier replier) override;
  bool capable(device::DeviceId device, std::uint8_t type, std::uint8_t subtype) const override;
  void barrier(device::Replier replier) override { client_.barrier(std::move(replier)); }

 private:
  struct Goal {
    geom::Pose X_OG;
    std::uint64_t drive = 0;  // number of the drive, which may have several goals
  };
  void ask_geometry();
  void take_body(const AnswerBody& body);
  void take_laser_geometry(const AnswerBody& body);
  void take_sonar_geometry(const AnswerBody& body);
  bool set_goal(std::optional<geom::Pose> X_OG);
  void take_news(std::vector<device::Publication>& more);
  void take_state(device::Publication& message);
  void take_scans(const std::optional<device::Publication>& laser,
                  const std::optional<device::Publication>& sonar);
  std::optional<NdRobot> robot() const;
  void steer(std::uint64_t drive_number, const geom::Pose& X_OG, const NdOut& out);
  void drive(double speed, double turn_rate);

  const Devices devices_;
  const NdOptions options_;
  device::Client client_;
  device::Subscription& position_;
  device::Subscription* laser_ = nullptr;  // null: not used
  device::Subscription* sonar_ = nullptr;
  device::DeviceId device_;
  NdMemory memory_;  // of the thread

  std::mutex mutex_;  // guards what follows
  std::optional<Goal> goal_;
  std::uint64_t drives_ = 0;  // so far
  bool gave_up_ = false;      // the last goal, being stuck
  std::optional<wire::position2d::Data> state_;
  // Once the geometry of the robot, the laser, the sonars is known.
  std::optional<geom::Box> body_;
  std::optional<geom::Pose> X_RS_;
  std::optional<std::vector<geom::Pose>> sonars_;

  AlgorithmThread thread_;  // last member: joined before what it uses is destroyed
};

}  // namespace playhouse::drivers
