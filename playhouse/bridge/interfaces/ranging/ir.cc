/// A ranger's array of transducers as interface ir: ranges, and the voltages
/// that a sensor of that range has on its output (docs/drivers.md).

#include "playhouse/wire/generated/ir.h"

#include <utility>

#include "playhouse/bridge/generated/device_makers.h"
#include "playhouse/bridge/interfaces/ranging/scan.h"
#include "playhouse/bridge/settings/device_with_power.h"

namespace playhouse::drivers {
namespace {

using wire::MessageType;

/// Of a Sharp GP2D12, which measures 0.1 to 0.8 m: the inverse of the range in cm that is commonly computed from
/// the counts n of a converter of 10 bits and 5 V, 6787 / (n - 3) - 4 (Acroname, "Linearizing Sharp Ranger
/// Data"). At 0.8 m it is 0.41 V; the data sheet has 0.4.  [m] to [V]
double infrared_voltage(double range) {
  return 5.0 / 1024 * (6787 / (100 * range + 4) + 3);
}

class Ir final : public DeviceWithPower {
 public:
  Ir(run::Simulation& simulation, world::ModelRow model)
      : DeviceWithPower(simulation, simulation.world().id(model)),
        poses_(wire::encode(wire::ir::Pose{sensor_poses(simulation.world(), model)})) {}

  std::span<const Served> served() const override {
    static constexpr Served kServed[] = {
        {MessageType::kReq, wire::ir::kReqPose},
        {MessageType::kReq, wire::ir::kReqPower},
    };
    return kServed;
  }

  void request(const device::Message& message, device::Replier replier) override {
    if (message.subtype == wire::ir::kReqPose) return replier.ack(poses_);
    const auto value = wire::decode<wire::ir::PowerReq>(message.body);
    if (!value) return;
    change_settings(std::move(replier), [on = value->state != 0](PowerSettings& wanted) {
      wanted.power = on;
      return true;
    });
  }

  void emit(const world::World& world, std::vector<device::Publication>& out) override {
    const std::optional<RangerRows> rows = fresh_rows(world, model());
    if (!rows || !settings().power) return;
    readings(world, *rows, readings_);
    wire::ir::Data data;
    for (const Reading& reading : readings_) {
      data.voltages.push_back(static_cast<float>(infrared_voltage(reading.range)));
      data.ranges.push_back(static_cast<float>(reading.range));
    }
    publish(world, wire::ir::kDataRanges, data, out);
  }

 private:
  Bytes poses_;
  std::vector<Reading> readings_;  // reused for its capacity
};

}  // namespace

std::unique_ptr<SimulatedDevice> make_ir_device(run::Simulation& simulation, world::ModelRow model) {
  return std::make_unique<Ir>(simulation, model);
}

}  // namespace playhouse::drivers
