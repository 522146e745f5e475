#include "playhouse/drivers/interfaces/ranging/laser.h"

#include <algorithm>

#include "playhouse/base/assert.h"
#include "playhouse/drivers/interfaces/shapes.h"
#include "playhouse/wire/generated/laser.h"
#include "playhouse/world/periods.h"

namespace playhouse::drivers {

namespace lsr = wire::laser;
using wire::MessageType;

namespace {

lsr::Config configuration(const world::World& world, world::ModelRow model,
                          const scene::RangerSensorDesc& sensor) {
  lsr::Config config;
  config.min_angle = static_cast<float>(-sensor.fov / 2);
  config.max_angle = static_cast<float>(sensor.fov / 2);
  config.resolution = static_cast<float>(angular_resolution(sensor));
  config.max_range = static_cast<float>(sensor.range_max);
  config.range_res = static_cast<float>(world.scene().resolution);
  config.intensity = 1;
  config.scanning_frequency = static_cast<float>(
      1 / (static_cast<double>(world::update_ticks(world, model)) * world.scene().interval));
  return config;
}

/// Clamps to a byte, branch-free, so that the loop is vectorised.
void put_intensities(std::span<const float> intensities, std::uint8_t* __restrict to) {
  const float* __restrict const from = intensities.data();
  for (std::size_t i = 0; i < intensities.size(); ++i) {
    const float below = from[i] < 255 ? from[i] : 255, clipped = below > 0 ? below : 0;
    to[i] = static_cast<std::uint8_t>(static_cast<std::int32_t>(clipped));
  }
}

}  // namespace

Laser::Laser(run::Simulation& simulation, world::ModelRow model)
    : SimulatedDevice(simulation, simulation.world().id(model)),
      scanner_(scanner_of(simulation.world(), model) -
               ranger_rows(simulation.world(), model).sensors.front()),
      sensor_(simulation.world().desc(model).sensors[scanner_]),
      configuration_(wire::encode(configuration(simulation.world(), model, sensor_))) {
  const geom::SpatialPose X_RS = geom::compose(pose_on_robot(simulation.world(), model), {sensor_.X_BS, {}});
  geometry_ = wire::encode(lsr::Geom{pose3d(X_RS), bbox3d(simulation.world().desc(model).size)});
  scan_.min_angle = static_cast<float>(-sensor_.fov / 2);
  scan_.max_angle = static_cast<float>(sensor_.fov / 2);
  scan_.resolution = static_cast<float>(angular_resolution(sensor_));
  scan_.max_range = static_cast<float>(sensor_.range_max);
}

std::span<const Served> Laser::served() const {
  static constexpr Served kServed[] = {
      {MessageType::kReq, lsr::kReqGetGeom},
      {MessageType::kReq, lsr::kReqGetConfig},
      {MessageType::kReq, lsr::kReqPower},
  };
  return kServed;
}

void Laser::request(const device::Message& message, device::Replier replier) {
  switch (message.subtype) {
    case lsr::kReqGetGeom:
      replier.ack(geometry_);
      return;
    case lsr::kReqGetConfig:
      replier.ack(configuration_);
      return;
    case lsr::kReqPower:  // always on while the device is open
      if (const auto value = wire::decode<lsr::PowerConfig>(message.body); value && value->state != 0)
        replier.ack();
      return;
    default:
      return;
  }
}

void Laser::emit(const world::World& world, std::vector<device::Publication>& out) {
  const std::optional<RangerRows> rows = fresh_rows(world, model());
  if (!rows) return;
  const Beams measured = beams(world, rows->sensors[scanner_]);
  scan_.id = static_cast<std::uint32_t>(world.tick());
  scan_.ranges.assign(measured.ranges.begin(), measured.ranges.end());
  scan_.intensity.resize(measured.intensities.size());
  put_intensities(measured.intensities, scan_.intensity.data());
  publish(world, lsr::kDataScan, scan_, out);
}

std::unique_ptr<SimulatedDevice> make_laser_device(run::Simulation& simulation, world::ModelRow model) {
  return std::make_unique<Laser>(simulation, model);
}

}  // namespace playhouse::drivers
