/// The messages of a radio as interface opaque (docs/radios.md).

#include "playhouse/wire/generated/opaque.h"

#include <algorithm>
#include <string>

#include "playhouse/base/limits.h"
#include "playhouse/base/log.h"
#include "playhouse/bridge/generated/device_makers.h"
#include "playhouse/bridge/interfaces/talk/radio_address.h"
#include "playhouse/world/radio_messages.h"

namespace playhouse::drivers {
namespace {

namespace op = wire::opaque;
using wire::MessageType;
using Payload = std::vector<std::uint8_t>;

bool send(world::Journal& journal, world::ModelId radio, world::ModelId to, const Payload& bytes) {
  const world::World& world = journal.world();
  const world::ModelRow row = world.row(radio);
  if (!row) return false;
  const bool is_full = world.wifis.outgoing[world.models.part[row]].size() >= limits::kRadioSends;
  journal.apply(world::changes::Send{radio, to, bytes});
  if (is_full)
    log::warn("{} has {} messages to send in one tick: the others are dropped", world.name(row),
              limits::kRadioSends);
  return !is_full;
}

/// Queues a message to the radio with this IP, or
/// a broadcast. False: no such radio, or no room.
bool send_to(world::Journal& journal, world::ModelId radio, const std::string& ip, const Payload& bytes) {
  if (ip.empty()) return send(journal, radio, {}, bytes);
  const world::ModelId to = radio_with_ip(journal.world(), ip);
  return to.valid() && send(journal, radio, to, bytes);
}

class Opaque final : public SimulatedDevice {
 public:
  Opaque(run::Simulation& simulation, world::ModelRow model)
      : SimulatedDevice(simulation, simulation.world().id(model)) {}

  std::span<const Served> served() const override {
    static constexpr Served kServed[] = {{MessageType::kCmd, op::kCmdData},
                                         {MessageType::kReq, op::kReqData}};
    return kServed;
  }

  /// Broadcast.
  device::Taken command(const device::Message& message) override {
    auto value = wire::decode<op::Data>(message.body);
    if (!value || value->data.size() > limits::kRadioMessageBytes) return device::Taken::kNo;
    const auto request = [id = model(), bytes = std::move(value->data)](world::Journal& journal) {
      send(journal, id, {}, bytes);
    };
    return simulation().requests().post(request, model()) ? device::Taken::kQueued : device::Taken::kNo;
  }

  /// Unicast: the bytes up to the first NUL are the address.
  void request(const device::Message& message, device::Replier replier) override {
    const auto value = wire::decode<op::Data>(message.body);
    if (!value) return;
    const Payload& data = value->data;
    const auto end = std::ranges::find(data, std::uint8_t{0});
    if (end == data.end() || data.end() - end - 1 > std::ptrdiff_t{limits::kRadioMessageBytes}) return;
    answer_by(std::move(replier),
              [id = model(), ip = std::string(data.begin(), end),
               bytes = Payload(end + 1, data.end())](world::Journal& journal) -> std::optional<Bytes> {
                if (!send_to(journal, id, ip, bytes)) return std::nullopt;
                return wire::encode(op::Data{});
              });
  }

  void emit(const world::World& world, std::vector<device::Publication>& out) override {
    const world::ModelRow row = world.row(model());
    if (!row) return;
    const world::WifiRow radio = world.models.part[row];
    world::each_message(world::incoming_of(world.wifis, radio), [&](const auto&, auto bytes) {
      publish(world, op::kDataState, op::Data{{bytes.begin(), bytes.end()}}, out);
    });
  }
};

}  // namespace

std::unique_ptr<SimulatedDevice> make_opaque_device(run::Simulation& simulation, world::ModelRow model) {
  return std::make_unique<Opaque>(simulation, model);
}

}  // namespace playhouse::drivers
