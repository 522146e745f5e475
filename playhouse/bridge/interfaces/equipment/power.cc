/// A battery as interface power (docs/drivers.md).

#include "playhouse/wire/generated/power.h"

#include "playhouse/bridge/generated/device_makers.h"
#include "playhouse/world/periods.h"
#include "playhouse/world/traits.h"

namespace playhouse::drivers {
namespace {

namespace pow = wire::power;
using wire::MessageType;

/// True if the model, or a part supplied by the same battery, can be charged.
bool can_be_charged(const world::World& world, world::ModelRow model) {
  if (world.desc(model).take_watts > 0) return true;
  for (const world::ModelRow child : world.children(model)) {
    const bool has_its_own = world::trait_row(world.packs, child).valid();
    if (!has_its_own && can_be_charged(world, {child})) return true;
  }
  return false;
}

class Power final : public SimulatedDevice {
 public:
  Power(run::Simulation& simulation, world::ModelRow model)
      : SimulatedDevice(simulation, simulation.world().id(model)),
        update_ticks_(world::update_ticks(simulation.world(), model)),
        can_be_charged_(drivers::can_be_charged(simulation.world(), model)) {}

  std::span<const Served> served() const override {
    static constexpr Served kServed[] = {{MessageType::kReq, pow::kReqSetChargingPolicy}};
    return kServed;
  }

  bool acts(std::uint8_t request) const override { return request == pow::kReqSetChargingPolicy; }
  void request(const device::Message& message, device::Replier replier) override {
    const auto value = wire::decode<pow::ChargepolicyConfig>(message.body);
    if (!value) return;
    change_world(std::move(replier),
                 world::changes::SetCharging{model(), value->enable_input != 0, value->enable_output != 0});
  }

  void emit(const world::World& world, std::vector<device::Publication>& out) override {
    if (world.tick() % update_ticks_ != 0) return;
    const world::ModelRow row = world.row(model());
    if (row) publish(world, pow::kDataState, state_of(world.packs, pack_of(world, row)), out);
  }

  void closed(world::Journal& journal) override {
    journal.apply(world::changes::SetCharging{model(), true, true});
  }

 private:
  static world::PackRow pack_of(const world::World& world, world::ModelRow model) {
    return world::trait_row(world.packs, model);  // traits never change
  }

  pow::Data state_of(const world::Packs& packs, world::PackRow pack) const {
    const double stored = packs.stored[pack], capacity = packs.capacity[pack];
    pow::Data data;
    data.valid = pow::kMaskWatts | pow::kMaskPercent | pow::kMaskCharging;
    data.watts = static_cast<float>(packs.watts[pack]);
    if (stored < 0) {
      data.percent = 100;
      data.charging = -1;
      return data;
    }
    data.valid |= pow::kMaskJoules;
    data.joules = static_cast<float>(stored);
    data.percent = capacity > 0 ? static_cast<float>(100 * stored / capacity) : 0;
    data.charging = can_be_charged_ && packs.takes[pack] != 0 ? packs.charging[pack] : -1;
    return data;
  }

  std::uint64_t update_ticks_;
  bool can_be_charged_;
};

}  // namespace

std::unique_ptr<SimulatedDevice> make_power_device(run::Simulation& simulation, world::ModelRow model) {
  return std::make_unique<Power>(simulation, model);
}

}  // namespace playhouse::drivers
