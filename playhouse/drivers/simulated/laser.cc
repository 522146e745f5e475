#include "playhouse/drivers/simulated/laser.h"

#include <algorithm>

#include "playhouse/base/assert.h"
#include "playhouse/drivers/simulated/shapes.h"
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

}  // namespace

Laser::Laser(Simulation& simulation, world::ModelRow model)
    : SimulatedDevice(simulation, simulation.world().id(model)),
      scanner_(scanner_of(simulation.world(), model).index -
               ranger_rows(simulation.world(), model).first_sensor),
      sensor_(simulation.world().desc(model).sensors[scanner_]),
      configuration_(wire::encode(configuration(simulation.world(), model, sensor_))) {
  const geom::Pose X_RS = geom::compose(pose_on_robot(simulation.world(), model), sensor_.X_BS);
  geometry_ = wire::encode(lsr::Geom{pose3d(X_RS), bbox3d(simulation.world().desc(model).size)});
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
  beams(world, {rows->first_sensor + scanner_}, readings_);
  lsr::Data scan;
  scan.min_angle = static_cast<float>(-sensor_.fov / 2);
  scan.max_angle = static_cast<float>(sensor_.fov / 2);
  scan.resolution = static_cast<float>(angular_resolution(sensor_));
  scan.max_range = static_cast<float>(sensor_.range_max);
  scan.id = static_cast<std::uint32_t>(world.tick());
  scan.ranges.reserve(readings_.size());
  scan.intensity.reserve(readings_.size());
  for (const Reading& reading : readings_) {
    scan.ranges.push_back(static_cast<float>(reading.range));
    scan.intensity.push_back(static_cast<std::uint8_t>(std::clamp(reading.intensity, 0.0, 255.0)));
  }
  publish(world, lsr::kDataScan, scan, out);
}

std::unique_ptr<SimulatedDevice> make_laser_device(Simulation& simulation, world::ModelRow model) {
  return std::make_unique<Laser>(simulation, model);
}

}  // namespace playhouse::drivers
