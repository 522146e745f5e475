#pragma once

/// The .cfg driver "vfh": drives a robot to goals with obstacle avoidance by laser. A position2d in front of
/// another one: goals are handled here (vfh_step.h, on a thread of its own), everything else is forwarded.

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
#include "playhouse/drivers/site.h"
#include "playhouse/drivers/vfh/vfh_step.h"
#include "playhouse/scene/cfg.h"
#include "playhouse/wire/generated/laser.h"
#include "playhouse/wire/generated/position2d.h"

namespace playhouse::drivers {

Result<std::unique_ptr<device::Driver>> make_vfh(const scene::CfgSection& section, Site& site);

class Vfh final : public device::Driver {
 public:
  /// Its client opens the robot and its laser, in this order, while the device is open.
  Vfh(device::Opener& opener, const VfhOptions& options);

  void set_device(device::DeviceId device) { device_ = device; }
  device::Client& client() { return client_; }
  AlgorithmThread& thread() { return thread_; }

  std::string_view name() const override { return "vfh"; }
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
  bool set_goal(std::optional<geom::Pose> X_OG);
  void take_news(std::vector<device::Publication>& more);
  void take_state(const device::Publication& message);
  void take_scan(const device::Publication& message);
  void steer(std::uint64_t drive_number, const geom::Pose& X_OG, const VfhOut& out);
  void drive(double speed, double turn_rate);

  const VfhOptions options_;
  device::Client client_;
  device::Subscription& position_;
  device::Subscription& scans_;
  device::DeviceId device_;
  VfhMemory memory_;  // of the thread

  std::mutex mutex_;  // guards what follows
  std::optional<Goal> goal_;
  std::uint64_t drives_ = 0;  // so far
  std::optional<wire::position2d::Data> state_;
  std::optional<double> radius_;    // m; once the robot's geometry is known
  std::optional<geom::Pose> X_RS_;  // once the laser's geometry is known

  AlgorithmThread thread_;  // last member: joined before what it uses is destroyed
};

}  // namespace playhouse::drivers
