#pragma once

/// A robot's drive as interface position2d: velocities, goals and odometry (docs/drivers.md).

#include "playhouse/drivers/generated/device_makers.h"

namespace playhouse::drivers {

class Position2d final : public SimulatedDevice {
 public:
  /// `model` is of kind kPosition.
  Position2d(run::Simulation& simulation, world::ModelRow model);

  world::ModelId robot() const override { return model(); }
  std::span<const Served> served() const override;
  device::Taken command(const device::Message& message) override;
  void request(const device::Message& message, device::Replier replier) override;
  bool acts(std::uint8_t request) const override;
  void emit(const world::World& world, std::vector<device::Publication>& out) override;
  void closed(world::Journal& journal) override;

 private:
  /// The change that a command requests; none if it is invalid.
  std::optional<world::Change> meaning(const device::Message& message) const;
  void set_odometry(const geom::Pose& X_OM, device::Replier replier);

  std::uint64_t update_ticks_;
  Bytes geometry_;
};

}  // namespace playhouse::drivers
