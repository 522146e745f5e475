#pragma once

/// A robot's drive as interface position2d: velocities, goals and odometry (docs/drivers.md).

#include "playhouse/bridge/generated/device_makers.h"
#include "playhouse/bridge/interfaces/motion/drive_settings.h"

namespace playhouse::drivers {

class Position2d final : public DriveDevice {
 public:
  /// `model` is of kind kPosition.
  Position2d(run::Simulation& simulation, world::ModelRow model);

  std::span<const Served> served() const override;
  device::Taken command(const device::Message& message) override;
  void request(const device::Message& message, device::Replier replier) override;
  bool acts(std::uint8_t request) const override;
  void emit(const world::World& world, std::vector<device::Publication>& out) override;

 private:
  /// The change that a command requests; none if it is invalid.
  std::optional<world::Change> meaning(const device::Message& message) const;
  void set_odometry(const geom::Pose& X_OM, device::Replier replier);

  std::uint64_t update_ticks_;
  Bytes geometry_;
};

}  // namespace playhouse::drivers
