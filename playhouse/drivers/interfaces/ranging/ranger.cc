#include "playhouse/drivers/interfaces/ranging/ranger.h"

#include "playhouse/drivers/interfaces/shapes.h"
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
  config.frequency = measuring_frequency(world, model);
  if (desc.sensors.empty()) return config;
  const scene::RangerSensorDesc& sensor = desc.sensors.front();
  config.min_angle = -sensor.fov / 2;
  config.max_angle = sensor.fov / 2;
  config.angular_res = angular_resolution(sensor);
  config.min_range = sensor.range_min;
  config.max_range = sensor.range_max;
  return config;
}

class Ranger final : public RangerDevice {
 public:
  Ranger(run::Simulation& simulation, world::ModelRow model)
      : RangerDevice(simulation, model, geometry(simulation.world(), model),
                     configuration(simulation.world(), model)) {}

 private:
  bool read(const world::World& world, std::vector<Reading>& out) const override {
    const std::optional<RangerRows> rows = fresh_rows(world, model());
    if (rows) readings(world, *rows, out);
    return rows.has_value();
  }
};

}  // namespace

double measuring_frequency(const world::World& world, world::ModelRow model) {
  return 1 / (static_cast<double>(world::update_ticks(world, model)) * world.scene().interval);
}

RangerDevice::RangerDevice(run::Simulation& simulation, world::ModelRow model, const rng::Geom& geometry,
                           const rng::Config& configuration)
    : SimulatedDevice(simulation, simulation.world().id(model)),
      geometry_(wire::encode(geometry)),
      configuration_(wire::encode(configuration)) {}

std::span<const Served> RangerDevice::served() const {
  static constexpr Served kServed[] = {
      {MessageType::kReq, rng::kReqGetGeom},
      {MessageType::kReq, rng::kReqGetConfig},
      {MessageType::kReq, rng::kReqPower},
      {MessageType::kReq, rng::kReqIntns},
  };
  return kServed;
}

void RangerDevice::request(const device::Message& message, device::Replier replier) {
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

void RangerDevice::emit(const world::World& world, std::vector<device::Publication>& out) {
  if (!read(world, readings_)) return;
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

std::unique_ptr<SimulatedDevice> make_ranger_device(run::Simulation& simulation, world::ModelRow model) {
  return std::make_unique<Ranger>(simulation, model);
}

}  // namespace playhouse::drivers
