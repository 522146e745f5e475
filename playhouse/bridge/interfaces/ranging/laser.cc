#include "playhouse/bridge/interfaces/ranging/laser.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "playhouse/bridge/interfaces/pose_on_robot.h"
#include "playhouse/drivers/shapes.h"
#include "playhouse/wire/generated/laser.h"
#include "playhouse/world/periods.h"

namespace playhouse::drivers {

namespace lsr = wire::laser;
using wire::MessageType;

namespace {

constexpr std::int32_t kMostScans = 10;  // that MEAN averages

std::uint32_t index_of_scanner(const world::World& world, world::ModelRow model) {
  return scanner_of(world, model) - ranger_rows(world, model).sensors.front();
}

ScanSource source_of(const world::World& world, world::ModelRow model) {
  const scene::RangerSensorDesc& sensor = world.desc(model).sensors[index_of_scanner(world, model)];
  ScanSource source{{}, static_cast<std::uint32_t>(sensor.samples), world::update_ticks(world, model)};
  source.usual.min_angle = -sensor.fov / 2;
  source.usual.max_angle = sensor.fov / 2;
  source.usual.resolution = angular_resolution(sensor);
  source.usual.min_range = sensor.range_min;
  source.usual.max_range = sensor.range_max;
  source.usual.range_res = world.scene().resolution;
  source.usual.frequency = measuring_frequency(world, model);
  return source;
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
    : DeviceWithSettings(simulation, simulation.world().id(model),
                         LaserSettings{source_of(simulation.world(), model).usual}),
      scanner_(index_of_scanner(simulation.world(), model)),
      source_(source_of(simulation.world(), model)) {
  const world::World& world = simulation.world();
  const scene::RangerSensorDesc& sensor = world.desc(model).sensors[scanner_];
  const geom::SpatialPose X_RS = geom::compose(pose_on_robot(world, model), {sensor.X_BS, {}});
  geometry_ = wire::encode(lsr::Geom{pose3d(X_RS), bbox3d(world.desc(model).size)});
  Laser::settled();
}

std::span<const Served> Laser::served() const {
  static constexpr Served kServed[] = {
      {MessageType::kReq, lsr::kReqGetGeom},   {MessageType::kReq, lsr::kReqGetConfig},
      {MessageType::kReq, lsr::kReqSetConfig}, {MessageType::kReq, lsr::kReqPower},
      {MessageType::kReq, lsr::kReqGetId},     {MessageType::kReq, lsr::kReqSetFilter},
  };
  return kServed;
}

std::span<const Laser::NamedSetting> Laser::named() const {
  static constexpr NamedSetting kNamed[] = {
      {"min_angle", &LaserSettings::min_angle},          {"max_angle", &LaserSettings::max_angle},
      {"resolution", &LaserSettings::resolution},        {"max_range", &LaserSettings::max_range},
      {"range_res", &LaserSettings::range_res},          {"intensity", &LaserSettings::intensity},
      {"scanning_frequency", &LaserSettings::frequency}, {"power", &LaserSettings::power},
  };
  return kNamed;
}

bool Laser::settle(LaserSettings& wanted) const {
  return choose(source_, wanted).has_value();
}

void Laser::settled() {
  LaserSettings now = settings();
  choice_ = *choose(source_, now);
  scan_.min_angle = static_cast<float>(now.min_angle);
  scan_.max_angle = static_cast<float>(now.max_angle);
  scan_.resolution = static_cast<float>(now.resolution);
  scan_.max_range = static_cast<float>(now.max_range);
  past_.clear();
}

void Laser::request(const device::Message& message, device::Replier replier) {
  switch (message.subtype) {
    case lsr::kReqGetGeom:
      return replier.ack(geometry_);
    case lsr::kReqGetId:
      return replier.ack(wire::encode(lsr::GetIdConfig{model().value}));
    case lsr::kReqGetConfig:
      return tell_settings(std::move(replier), [](const LaserSettings& settings) {
        return wire::encode(laser_config(settings));
      });
    case lsr::kReqSetConfig:
      if (const auto value = wire::decode<lsr::Config>(message.body))
        set_configuration(*value, std::move(replier));
      return;
    case lsr::kReqSetFilter:
      if (const auto value = wire::decode<lsr::SetFilterConfig>(message.body))
        set_filter(*value, std::move(replier));
      return;
    default:  // POWER
      if (const auto value = wire::decode<lsr::PowerConfig>(message.body))
        change_settings(std::move(replier), [on = value->state != 0](LaserSettings& wanted) {
          wanted.power = on;
          return true;
        });
      return;
  }
}

/// 0 leaves a value as it is: libplayerc sends no max_range.
void Laser::set_configuration(const lsr::Config& config, device::Replier replier) {
  const auto edit = [config](LaserSettings& wanted) {
    wanted.min_angle = static_cast<double>(config.min_angle);
    wanted.max_angle = static_cast<double>(config.max_angle);
    if (config.resolution != 0) wanted.resolution = laser_resolution(config.resolution);
    if (config.max_range != 0) wanted.max_range = static_cast<double>(config.max_range);
    if (config.range_res != 0) wanted.range_res = static_cast<double>(config.range_res);
    if (config.scanning_frequency != 0) wanted.frequency = static_cast<double>(config.scanning_frequency);
    wanted.intensity = config.intensity != 0;
    return true;
  };
  change_settings(std::move(replier), edit,
                  [](const LaserSettings& settings) { return wire::encode(laser_config(settings)); });
}

void Laser::set_filter(const lsr::SetFilterConfig& filter, device::Replier replier) {
  const auto edit = [filter](LaserSettings& wanted) {
    const std::vector<float>& given = filter.parameters;
    if (std::ranges::any_of(given, [](float each) { return !std::isfinite(each); })) return false;
    switch (filter.filter_type) {
      case lsr::kFilterMedian:
        wanted.median = given.empty() || given[0] != 0;
        return given.size() <= 1;
      case lsr::kFilterEdge:  // a simulated beam has no width, with which it would hit two things at an edge
        return given.size() <= 1;
      case lsr::kFilterRange:
        wanted.low = given.empty() ? 0 : static_cast<double>(given[0]);
        wanted.high = given.empty() ? 0 : static_cast<double>(given.back());
        return given.empty() || (given.size() == 2 && given[0] >= 0 && given[0] < given[1]);
      case lsr::kFilterMean:
        if (given.size() != 1 || given[0] < 1 || given[0] > kMostScans || given[0] != std::floor(given[0]))
          return false;
        wanted.mean_over = static_cast<std::int32_t>(given[0]);
        return true;
      default:
        return false;
    }
  };
  change_settings(std::move(replier), edit);
}

void Laser::pick(const Beams& measured) {
  const LaserSettings& set = settings();
  scan_.ranges.resize(choice_.count);
  for (std::uint32_t i = 0; i < choice_.count; ++i)
    scan_.ranges[i] = measured.ranges[choice_.first + i * choice_.stride];
  if (set.mean_over > 1) average();
  if (set.median && choice_.count > 2) {
    const std::vector<float> from = scan_.ranges;
    for (std::uint32_t i = 1; i + 1 < choice_.count; ++i)
      scan_.ranges[i] =
          std::max(std::min(from[i - 1], from[i]), std::min(std::max(from[i - 1], from[i]), from[i + 1]));
  }
  scan_.intensity.resize(choice_.count);
  for (std::uint32_t i = 0; i < choice_.count; ++i) {
    const auto range = static_cast<double>(scan_.ranges[i]);
    const bool is_beyond = set.high > 0 && (range < set.low || range > set.high);
    scan_.ranges[i] = static_cast<float>(is_beyond ? set.max_range : shown_range(source_, set, range));
    const bool is_hit = !is_beyond && (range < set.max_range || set.max_range == source_.usual.max_range);
    const float intensity = is_hit ? measured.intensities[choice_.first + i * choice_.stride] : 0;
    put_intensities({&intensity, 1}, &scan_.intensity[i]);
  }
}

/// Beams without a hit count with their range, as in the devices that have such a filter.
void Laser::average() {
  past_.push_back(scan_.ranges);
  if (past_.size() > static_cast<std::size_t>(settings().mean_over)) past_.pop_front();
  for (std::size_t i = 0; i < scan_.ranges.size(); ++i) {
    double sum = 0;
    for (const std::vector<float>& ranges : past_) sum += static_cast<double>(ranges[i]);
    scan_.ranges[i] = static_cast<float>(sum / static_cast<double>(past_.size()));
  }
}

void Laser::emit(const world::World& world, std::vector<device::Publication>& out) {
  const std::optional<RangerRows> rows = fresh_rows(world, model());
  const LaserSettings& set = settings();
  if (!rows || !set.power || !choice_.is_due(source_, world.tick())) return;
  const Beams measured = beams(world, rows->sensors[scanner_]);
  scan_.id = static_cast<std::uint32_t>(world.tick());
  if (choice_.all && !set.median && set.high == 0 && set.mean_over == 1) {
    scan_.ranges.assign(measured.ranges.begin(), measured.ranges.end());
    scan_.intensity.resize(measured.intensities.size());
    put_intensities(measured.intensities, scan_.intensity.data());
  } else {
    pick(measured);
  }
  if (!set.intensity) scan_.intensity.clear();
  publish(world, lsr::kDataScan, scan_, out);
}

std::unique_ptr<SimulatedDevice> make_laser_device(run::Simulation& simulation, world::ModelRow model) {
  return std::make_unique<Laser>(simulation, model);
}

}  // namespace playhouse::drivers
