/// The contacts and lamps of a model and its parts as interface dio (docs/drivers.md): inputs are
/// the switches of its bumpers, outputs its lamps, both in the order of the file.

#include "playhouse/wire/generated/dio.h"

#include <algorithm>
#include <utility>

#include "playhouse/bridge/generated/device_makers.h"
#include "playhouse/bridge/simulated/model_interfaces.h"
#include "playhouse/world/periods.h"

namespace playhouse::drivers {
namespace {

namespace changes = world::changes;
using wire::MessageType;

constexpr std::uint32_t kLines = 32;  // inputs, and outputs: the bits of a message

/// A switch of a bumper.
struct Contact {
  world::ModelId bumper;
  std::size_t number = 0;
};

/// Switches a lamp; one that has gone stays as it was.
void switch_lamp(world::Journal& journal, world::ModelId lamp, bool on) {
  const world::ModelRow row = journal.world().row(lamp);
  if (!row) return;
  if (journal.world().models.kind[row] == scene::ModelKind::kBlinkenlight) {
    journal.apply(changes::SwitchLight{lamp, on});
  } else {
    journal.apply(changes::SwitchIndicator{lamp, on});
  }
}

class Dio final : public SimulatedDevice {
 public:
  Dio(run::Simulation& simulation, world::ModelRow model)
      : SimulatedDevice(simulation, simulation.world().id(model)),
        update_ticks_(world::update_ticks(simulation.world(), model)) {
    const world::World& world = simulation.world();
    each_part(world, model, [&](world::ModelRow part) {
      if (world.models.kind[part] == scene::ModelKind::kBumper) add_contacts(world, part);
      if (is_lamp(world.models.kind[part]) && lamps_.size() < kLines) lamps_.push_back(world.id(part));
    });
  }

  std::span<const Served> served() const override {
    static constexpr Served kServed[] = {{MessageType::kCmd, wire::dio::kCmdValues}};
    return kServed;
  }
  void request(const device::Message&, device::Replier) override {}

  /// Commands may set different outputs, so they are queued rather than replaced.
  device::Taken command(const device::Message& message) override {
    const auto value = wire::decode<wire::dio::Cmd>(message.body);
    if (!value || value->count > kLines || lamps_.empty()) return device::Taken::kNo;
    const std::size_t count = std::min<std::size_t>(value->count, lamps_.size());
    const auto request =
        [lamps = std::vector(lamps_.begin(), lamps_.begin() + static_cast<std::ptrdiff_t>(count)),
         bits = value->digout](world::Journal& journal) {
          for (std::size_t i = 0; i < lamps.size(); ++i) switch_lamp(journal, lamps[i], (bits >> i & 1) != 0);
        };
    return simulation().requests().post(request, model()) ? device::Taken::kQueued : device::Taken::kNo;
  }
  /// A lamp that is switched does not start the robot that carries it.
  bool commands_act() const override { return false; }

  void emit(const world::World& world, std::vector<device::Publication>& out) override {
    if (!is_due(world)) return;
    wire::dio::Data data;
    data.count = static_cast<std::uint32_t>(contacts_.size());
    for (std::size_t i = 0; i < contacts_.size(); ++i)
      if (is_pressed(world, contacts_[i])) data.bits |= 1u << i;
    publish(world, wire::dio::kDataValues, data, out);
  }

  /// Bumpers measure while somebody reads them, and lamps flash.
  void opened(world::Journal& journal) override {
    uses_.clear();
    const auto watch = [&](world::ModelId part) {
      if (part != model()) uses_.emplace_back().watch(journal, simulation().requests(), part);
    };
    std::ranges::for_each(bumpers_, watch);
    std::ranges::for_each(lamps_, watch);
  }
  void ended(world::Journal& journal) override {
    for (world::Use& use : uses_) use.end(journal, simulation().requests());
    uses_.clear();
  }

 private:
  void add_contacts(const world::World& world, world::ModelRow bumper) {
    const std::size_t count = world.desc(bumper).bumper->X_BS.size();
    for (std::size_t k = 0; k < count && contacts_.size() < kLines; ++k) {
      if (k == 0) bumpers_.push_back(world.id(bumper));
      contacts_.push_back({world.id(bumper), k});
    }
  }

  /// With a bumper in each tick in which one has measured; without one at the interval of the model.
  bool is_due(const world::World& world) const {
    const auto is_there = [&](world::ModelId bumper) { return static_cast<bool>(world.row(bumper)); };
    if (std::ranges::none_of(bumpers_, is_there))
      return world.row(model()) && world.tick() % update_ticks_ == 0;
    return std::ranges::any_of(bumpers_, [&](world::ModelId bumper) {
      const world::ModelRow row = world.row(bumper);
      return row && world.bumpers.measured_tick[world.models.part[row]] == world.tick();
    });
  }

  static bool is_pressed(const world::World& world, const Contact& contact) {
    const world::ModelRow row = world.row(contact.bumper);
    if (!row) return false;
    const std::vector<world::ModelId>& hits = world.bumpers.hits[world.models.part[row]];
    return contact.number < hits.size() && hits[contact.number];
  }

  std::uint64_t update_ticks_;
  std::vector<Contact> contacts_;        // the inputs
  std::vector<world::ModelId> bumpers_;  // that have them
  std::vector<world::ModelId> lamps_;    // the outputs
  std::vector<world::Use> uses_;         // of both, while it is open
};

}  // namespace

std::unique_ptr<SimulatedDevice> make_dio_device(run::Simulation& simulation, world::ModelRow model) {
  return std::make_unique<Dio>(simulation, model);
}

}  // namespace playhouse::drivers
