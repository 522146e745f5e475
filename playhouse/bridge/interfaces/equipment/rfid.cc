/// A reader of radio tags as interface rfid (docs/drivers.md). On the wire requests say nothing more than what they
/// are: none tells what to write, or which tag to lock.

#include "playhouse/wire/generated/rfid.h"

#include <utility>

#include "playhouse/bridge/generated/device_makers.h"
#include "playhouse/bridge/settings/device_with_power.h"
#include "playhouse/scene/forms/tag_id.h"

namespace playhouse::drivers {
namespace {

using wire::MessageType;

class Rfid final : public DeviceWithPower {
 public:
  Rfid(run::Simulation& simulation, world::ModelRow model)
      : DeviceWithPower(simulation, simulation.world().id(model)) {}

  std::span<const Served> served() const override {
    static constexpr Served kServed[] = {
        {MessageType::kReq, wire::rfid::kReqPower},
        {MessageType::kReq, wire::rfid::kReqReadtag},
    };
    return kServed;
  }

  void request(const device::Message& message, device::Replier replier) override {
    if (message.subtype == wire::rfid::kReqReadtag) return say_if_there_is_a_tag(std::move(replier));
    change_settings(std::move(replier), [](PowerSettings& wanted) {
      wanted.power = !wanted.power;
      return true;
    });
  }

  void emit(const world::World& world, std::vector<device::Publication>& out) override {
    const world::ModelRow row = world.row(model());
    if (!row || !settings().power) return;
    const world::RfidRow reader = world.models.part[row];
    if (world.rfids.measured_tick[reader] != world.tick()) return;
    wire::rfid::Data data;
    for (const world::TagInRange& tag : world.rfids.tags[reader])
      if (const world::ModelRow target = world.row(tag.target))
        data.tags.push_back(
            {world.desc(target).rfid_type, scene::tag_id(world.desc(target).rfid_tag).value_or("")});
    publish(world, wire::rfid::kDataTags, data, out);
  }

 private:
  void say_if_there_is_a_tag(device::Replier replier) {
    answer_by(std::move(replier),
              [self = shared_from_this(), this](world::Journal& journal) -> std::optional<Bytes> {
                const world::World& world = journal.world();
                const world::ModelRow row = world.row(model());
                if (!row || !settings().power || world.rfids.tags[world.models.part[row]].empty())
                  return std::nullopt;
                return Bytes();
              });
  }
};

}  // namespace

std::unique_ptr<SimulatedDevice> make_rfid_device(run::Simulation& simulation, world::ModelRow model) {
  return std::make_unique<Rfid>(simulation, model);
}

}  // namespace playhouse::drivers
