#include "playhouse/drivers/simulated/ranger.h"

#include "playhouse/drivers/simulated/shapes.h"
#include "playhouse/wire/generated/ranger.h"
#include "playhouse/world/periods.h"

namespace playhouse::drivers {

namespace rng = wire::ranger;
using wire::MessageType;

namespace {

rng::Geom geometry(const world::World& world, world::ModelRow model) {
  const scene::ModelDesc& desc = world.desc(model);
  rng::Geom geom{pose3d(pose_on_robot(world, model)), bbox3d(desc.size), {}, {}};
  for (const scene::RangerSensorDesc& sensor : desc.sensors) {
    geom.element_poses.push_back(pose3d(sensor.X_BS));
    geom.element_sizes.push_back(bbox3d(sensor.size));
  }
  return geom;
}

rng::Config configuration(const world::World& world, world::ModelRow model) {
  const scene::ModelDesc& desc = world.desc(model);
  rng::Config config;
  config.range_res = world.scene().resolution;
  config.frequency = 1 / (static_cast<double>(world::update_ticks(world, model)) * world.scene().interval);
  if (desc.sensors.empty()) return config;
  const scene::RangerSensorDesc& sensor = desc.sensors.front();
  config.min_angle = -sensor.fov / 2;
  config.max_angle = sensor.fov / 2;
  config.angular_res = angular_resolution(sensor);
  config.min_range = sensor.range_min;
  config.max_range = sensor.range_max;
  return config;
}

}  // namespace

Ranger::Ranger(Simulation& simulation, world::ModelRow model)
    : SimulatedDevice(simulation, simulation.world().id(model)),
      geometry_(wire::encode(geometry(simulation.world(), model))),
      configuration_(wire::encode(configuration(simulation.world(), model))) {}

std::span<const Served> Ranger::served() const {
  static constexpr Served kServed[] = {
      {MessageType::kReq, rng::kReqGetGeom},
      {MessageType::kReq, rng::kReqGetConfig},
      {MessageType::kReq, rng::kReqPower},
      {MessageType::kReq, rng::kReqIntns},
  };
  return kServed;
}

void Ranger::request(const device::Message& message, device::Replier replier) {
  switch (message.subtype) {
    case rng::kReqGetGeom:
      replier.ack(geometry_);
      return;
    case rng::kReqGetConfig:
      replier.ack(configuration_);
      return;
    case rng::kReqPower:
    case rng::kReqIntns:
      // Power and intensities are always on while the device is open, so "on" is all that can be granted.
      if (const auto value = wire::decode<rng::PowerConfig>(message.body); value && value->state != 0)
        replier.ack();
      return;
    default:
      return;
  }
}

void Ranger::emit(const world::World& world, std::vector<device::Publication>& out) {
  const std::optional<RangerRows> rows = fresh_rows(world, model());
  if (!rows) return;
  readings(world, *rows, readings_);
  rng::DataRange ranges;
  rng::DataIntns intensities;
  ranges.ranges.reserve(readings_.size());
  intensities.intensities.reserve(readings_.size());
  for (const Reading& reading : readings_) {
    ranges.ranges.push_back(reading.range);
    intensities.intensities.push_back(reading.intensity);
  }
  publish(world, rng::kDataRange, ranges, out);
  publish(world, rng::kDataIntns, intensities, out);
}

std::unique_ptr<SimulatedDevice> make_ranger_device(Simulation& simulation, world::ModelRow model) {
  return std::make_unique<Ranger>(simulation, model);
}

}  // namespace playhouse::drivers
