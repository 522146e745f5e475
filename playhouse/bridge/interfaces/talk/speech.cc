/// What a model of any kind says, as interface speech (docs/drivers.md).

#include "playhouse/wire/generated/speech.h"

#include "playhouse/bridge/generated/device_makers.h"
#include "playhouse/world/speech.h"

namespace playhouse::drivers {
namespace {

using wire::MessageType;

class Speech final : public SimulatedDevice {
 public:
  Speech(run::Simulation& simulation, world::ModelRow model)
      : SimulatedDevice(simulation, simulation.world().id(model)) {}

  std::span<const Served> served() const override {
    static constexpr Served kServed[] = {{MessageType::kCmd, wire::speech::kCmdSay}};
    return kServed;
  }

  void request(const device::Message&, device::Replier) override {}

  device::Taken command(const device::Message& message) override {
    const auto value = wire::decode<wire::speech::Cmd>(message.body);
    if (!value) return device::Taken::kNo;
    // Truncated by set_say() anyway: limits the queue's memory.
    const auto say = [change = world::changes::Say{model(), world::spoken(value->string)}](
                         world::Journal& journal) { journal.apply(change); };
    return simulation().requests().post(say, model()) ? device::Taken::kQueued : device::Taken::kNo;
  }
};

}  // namespace

std::unique_ptr<SimulatedDevice> make_speech_device(run::Simulation& simulation, world::ModelRow model) {
  return std::make_unique<Speech>(simulation, model);
}

}  // namespace playhouse::drivers
