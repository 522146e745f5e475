#include "playhouse/bridge/interfaces/ranging/ranger.h"

#include <utility>

#include "playhouse/bridge/interfaces/pose_on_robot.h"
#include "playhouse/drivers/shapes.h"
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

ScanSource source_of(const world::World& world, world::ModelRow model) {
  const scene::ModelDesc& desc = world.desc(model);
  ScanSource source;
  source.update_ticks = world::update_ticks(world, model);
  ScanSettings& usual = source.usual;
  usual.range_res = world.scene().resolution;
  usual.frequency = measuring_frequency(world, model);
  if (desc.sensors.empty()) return source;
  const scene::RangerSensorDesc& sensor = desc.sensors.front();
  if (desc.sensors.size() == 1) source.beams = static_cast<std::uint32_t>(sensor.samples);
  usual.min_angle = -sensor.fov / 2;
  usual.max_angle = sensor.fov / 2;
  usual.resolution = angular_resolution(sensor);
  usual.min_range = sensor.range_min;
  usual.max_range = sensor.range_max;
  return source;
}

class Ranger final : public RangerDevice {
 public:
  Ranger(run::Simulation& simulation, world::ModelRow model)
      : RangerDevice(simulation, model, geometry(simulation.world(), model),
                     source_of(simulation.world(), model)) {}

 private:
  bool read(const world::World& world, std::vector<Reading>& out) const override {
    const std::optional<RangerRows> rows = fresh_rows(world, model());
    if (rows) readings(world, *rows, out);
    return rows.has_value();
  }
};

}  // namespace

RangerDevice::RangerDevice(run::Simulation& simulation, world::ModelRow model, rng::Geom geometry,
                           const ScanSource& source)
    : DeviceWithSettings(simulation, simulation.world().id(model), source.usual),
      geometry_(std::move(geometry)),
      source_(source) {
  RangerDevice::settled();
  is_new_ = false;
}

std::span<const Served> RangerDevice::served() const {
  static constexpr Served kServed[] = {
      {MessageType::kReq, rng::kReqGetGeom},   {MessageType::kReq, rng::kReqGetConfig},
      {MessageType::kReq, rng::kReqSetConfig}, {MessageType::kReq, rng::kReqPower},
      {MessageType::kReq, rng::kReqIntns},
  };
  return kServed;
}

std::span<const RangerDevice::NamedSetting> RangerDevice::named() const {
  static constexpr NamedSetting kNamed[] = {
      {"min_angle", &ScanSettings::min_angle},    {"max_angle", &ScanSettings::max_angle},
      {"angular_res", &ScanSettings::resolution}, {"min_range", &ScanSettings::min_range},
      {"max_range", &ScanSettings::max_range},    {"range_res", &ScanSettings::range_res},
      {"frequency", &ScanSettings::frequency},    {"power", &ScanSettings::power},
      {"intensity", &ScanSettings::intensity},
  };
  return kNamed;
}

void RangerDevice::settled() {
  ScanSettings now = settings();
  choice_ = *choose(source_, now);
  is_new_ = true;
}

/// Who opens it next asks for its configuration.
void RangerDevice::ended(world::Journal& journal) {
  DeviceWithSettings::ended(journal);
  is_new_ = false;
}

void RangerDevice::request(const device::Message& message, device::Replier replier) {
  switch (message.subtype) {
    case rng::kReqGetGeom:
      return replier.ack(wire::encode(geometry_));
    case rng::kReqGetConfig:
      return tell_settings(std::move(replier), [](const ScanSettings& settings) {
        return wire::encode(ranger_config(settings));
      });
    case rng::kReqSetConfig:
      if (const auto value = wire::decode<rng::Config>(message.body))
        set_configuration(*value, std::move(replier));
      return;
    default:  // POWER, INTNS
      if (const auto value = wire::decode<rng::PowerConfig>(message.body)) {
        bool ScanSettings::*const which =
            message.subtype == rng::kReqPower ? &ScanSettings::power : &ScanSettings::intensity;
        change_settings(std::move(replier), [which, on = value->state != 0](ScanSettings& wanted) {
          wanted.*which = on;
          return true;
        });
      }
      return;
  }
}

/// 0 leaves a resolution, the maximum range and the frequency as they are.
void RangerDevice::set_configuration(const rng::Config& config, device::Replier replier) {
  const auto edit = [config](ScanSettings& wanted) {
    wanted.min_angle = config.min_angle;
    wanted.max_angle = config.max_angle;
    if (config.angular_res != 0) wanted.resolution = config.angular_res;
    wanted.min_range = config.min_range;
    if (config.max_range != 0) wanted.max_range = config.max_range;
    if (config.range_res != 0) wanted.range_res = config.range_res;
    if (config.frequency != 0) wanted.frequency = config.frequency;
    return true;
  };
  change_settings(std::move(replier), edit,
                  [](const ScanSettings& settings) { return wire::encode(ranger_config(settings)); });
}

void RangerDevice::pick() {
  const ScanSettings& set = settings();
  if (readings_.size() == source_.beams) {
    for (std::uint32_t i = 0; i < choice_.count; ++i)
      readings_[i] = readings_[choice_.first + i * choice_.stride];
    readings_.resize(choice_.count);
  }
  for (Reading& reading : readings_) {
    if (reading.range >= set.max_range && set.max_range != source_.usual.max_range) reading.intensity = 0;
    reading.range = shown_range(source_, set, reading.range);
  }
}

void RangerDevice::emit(const world::World& world, std::vector<device::Publication>& out) {
  if (!settings().power || !choice_.is_due(source_, world.tick()) || !read(world, readings_)) return;
  if (!choice_.all) pick();
  rng::DataRange ranges;
  rng::DataIntns intensities;
  ranges.ranges.reserve(readings_.size());
  intensities.intensities.reserve(readings_.size());
  for (const Reading& reading : readings_) {
    ranges.ranges.push_back(reading.range);
    intensities.intensities.push_back(reading.intensity);
  }
  if (is_new_) {
    const rng::Config config = ranger_config(settings());
    publish(world, rng::kDataRangestamped, rng::DataRangestamped{ranges, 1, geometry_, 1, config}, out);
    if (settings().intensity)
      publish(world, rng::kDataIntnsstamped, rng::DataIntnsstamped{intensities, 1, geometry_, 1, config},
              out);
    is_new_ = false;
  }
  publish(world, rng::kDataRange, ranges, out);
  if (settings().intensity) publish(world, rng::kDataIntns, intensities, out);
}

std::unique_ptr<SimulatedDevice> make_ranger_device(run::Simulation& simulation, world::ModelRow model) {
  return std::make_unique<Ranger>(simulation, model);
}

}  // namespace playhouse::drivers
