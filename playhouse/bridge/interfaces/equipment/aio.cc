/// A custom model as interface aio: readings are voltages of
/// inputs, commands voltages of outputs (docs/drivers.md).

#include "playhouse/wire/generated/aio.h"

#include <cmath>

#include "playhouse/base/limits.h"
#include "playhouse/bridge/generated/device_makers.h"

namespace playhouse::drivers {
namespace {

namespace aio = wire::aio;
using wire::MessageType;

class Aio final : public SimulatedDevice {
 public:
  Aio(run::Simulation& simulation, world::ModelRow model)
      : SimulatedDevice(simulation, simulation.world().id(model)) {}

  std::span<const Served> served() const override {
    static constexpr Served kServed[] = {{MessageType::kCmd, aio::kCmdState}};
    return kServed;
  }
  void request(const device::Message&, device::Replier) override {}

  /// Commands set different outputs, so they are queued rather than replaced.
  device::Taken command(const device::Message& message) override {
    const auto value = wire::decode<aio::Cmd>(message.body);
    if (!value || !std::isfinite(value->voltage) || value->id >= limits::kCustomNumbers)
      return device::Taken::kNo;
    const world::changes::CommandCustom change{model(), value->id, value->voltage};
    const auto request = [change](world::Journal& journal) { journal.apply(change); };
    return simulation().requests().post(request, model()) ? device::Taken::kQueued : device::Taken::kNo;
  }

  void emit(const world::World& world, std::vector<device::Publication>& out) override {
    const world::ModelRow row = world.row(model());
    if (!row) return;
    const world::CustomRow custom = world.models.part[row];
    if (world.customs.measured_tick[custom] != world.tick()) return;
    aio::Data data;
    for (const double reading : world.customs.readings[custom])
      data.voltages.push_back(static_cast<float>(reading));
    publish(world, aio::kDataState, data, out);
  }
};

}  // namespace

std::unique_ptr<SimulatedDevice> make_aio_device(run::Simulation& simulation, world::ModelRow model) {
  return std::make_unique<Aio>(simulation, model);
}

}  // namespace playhouse::drivers
