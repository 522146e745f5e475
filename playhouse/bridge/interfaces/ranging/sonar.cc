#include "playhouse/bridge/interfaces/ranging/sonar.h"

#include <utility>

#include "playhouse/wire/generated/sonar.h"

namespace playhouse::drivers {

namespace snr = wire::sonar;
using wire::MessageType;

Sonar::Sonar(run::Simulation& simulation, world::ModelRow model)
    : DeviceWithPower(simulation, simulation.world().id(model)),
      geometry_(wire::encode(snr::Geom{sensor_poses(simulation.world(), model)})) {}

std::span<const Served> Sonar::served() const {
  static constexpr Served kServed[] = {
      {MessageType::kReq, snr::kReqGetGeom},
      {MessageType::kReq, snr::kReqPower},
  };
  return kServed;
}

void Sonar::request(const device::Message& message, device::Replier replier) {
  if (message.subtype == snr::kReqGetGeom) return replier.ack(geometry_);
  const auto value = wire::decode<snr::PowerConfig>(message.body);
  if (!value) return;
  change_settings(std::move(replier), [on = value->state != 0](PowerSettings& wanted) {
    wanted.power = on;
    return true;
  });
}

void Sonar::emit(const world::World& world, std::vector<device::Publication>& out) {
  const std::optional<RangerRows> rows = fresh_rows(world, model());
  if (!rows || !settings().power) return;
  readings(world, *rows, readings_);
  snr::Data data;
  data.ranges.reserve(readings_.size());
  for (const Reading& reading : readings_) data.ranges.push_back(static_cast<float>(reading.range));
  publish(world, snr::kDataRanges, data, out);
}

std::unique_ptr<SimulatedDevice> make_sonar_device(run::Simulation& simulation, world::ModelRow model) {
  return std::make_unique<Sonar>(simulation, model);
}

}  // namespace playhouse::drivers
