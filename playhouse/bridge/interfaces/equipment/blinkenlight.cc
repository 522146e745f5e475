/// A lamp, or a steady light, as interface blinkenlight (docs/drivers.md).

#include <cmath>

#include "playhouse/bridge/generated/device_makers.h"
#include "playhouse/scene/forms/colors.h"
#include "playhouse/wire/generated/blinkenlight.h"
#include "playhouse/world/periods.h"

namespace playhouse::drivers {
namespace {

namespace bl = wire::blinkenlight;
namespace changes = world::changes;
using wire::MessageType;

wire::Color color_of(const scene::Color& color) {
  const std::uint32_t rgba = scene::rgba8(color);
  const auto byte = [rgba](unsigned shift) { return static_cast<std::uint8_t>(rgba >> shift); };
  return {byte(0), byte(24), byte(16), byte(8)};
}

/// Player clients send alpha 0: keeps the model's.
void set_color(world::Journal& journal, world::ModelId model, const wire::Color& color) {
  const world::World& world = journal.world();
  const world::ModelRow row = world.row(model);
  if (!row) return;
  const scene::Color wanted{static_cast<float>(color.red) / 255, static_cast<float>(color.green) / 255,
                            static_cast<float>(color.blue) / 255, world.models.color[row].a};
  journal.apply(changes::SetColor{model, wanted});
}

/// True for valid flash parameters.
bool is_flash(float period, float dutycycle) {
  return std::isfinite(period) && period >= 0 && dutycycle >= 0 && dutycycle <= 1;
}

/// Common part of lights: colour.
class Light : public SimulatedDevice {
 public:
  Light(run::Simulation& simulation, world::ModelRow model)
      : SimulatedDevice(simulation, simulation.world().id(model)),
        update_ticks_(world::update_ticks(simulation.world(), model)) {}

  void request(const device::Message&, device::Replier) final {}

  /// Commands set different properties, so they are queued rather than replaced.
  device::Taken command(const device::Message& message) final {
    const run::Request setting = meaning(message);
    if (!setting) return device::Taken::kNo;
    return simulation().requests().post(setting, model()) ? device::Taken::kQueued : device::Taken::kNo;
  }

  void emit(const world::World& world, std::vector<device::Publication>& out) final {
    if (world.tick() % update_ticks_ != 0) return;
    const world::ModelRow row = world.row(model());
    if (!row) return;
    bl::Data data = data_of(world, world.models.part[row]);
    data.color = color_of(world.models.color[row]);
    publish(world, bl::kDataState, data, out);
  }

 protected:
  /// The setting that a command requests; empty if invalid. The only light has number 0.
  virtual run::Request meaning(const device::Message& message) const = 0;
  /// Data of row `light` of its table.
  virtual bl::Data data_of(const world::World& world, world::KindRow light) const = 0;

  run::Request color(const device::Message& message) const {
    const auto value = wire::decode<bl::CmdColor>(message.body);
    if (!value || value->id != 0) return {};
    return [id = model(), color = value->color](world::Journal& journal) { set_color(journal, id, color); };
  }

 private:
  std::uint64_t update_ticks_;
};

class Blinkenlight final : public Light {
 public:
  using Light::Light;

  std::span<const Served> served() const override {
    static constexpr Served kServed[] = {
        {MessageType::kCmd, bl::kCmdState},
        {MessageType::kCmd, bl::kCmdPower},
        {MessageType::kCmd, bl::kCmdColor},
        {MessageType::kCmd, bl::kCmdFlash},
    };
    return kServed;
  }

 private:
  /// Applies changes that are one setting.
  template <typename... Each>
  static run::Request all(const Each&... each) {
    return [each...](world::Journal& journal) { (journal.apply(each), ...); };
  }

  run::Request meaning(const device::Message& message) const override {
    switch (message.subtype) {
      case bl::kCmdColor:
        return color(message);
      case bl::kCmdPower:
        if (const auto value = wire::decode<bl::CmdPower>(message.body); value && value->id == 0)
          return all(changes::SwitchLight{model(), value->enable != 0});
        return {};
      case bl::kCmdFlash:
        if (const auto value = wire::decode<bl::CmdFlash>(message.body);
            value && value->id == 0 && is_flash(value->period, value->dutycycle))
          return all(changes::FlashLight{model(), value->period, value->dutycycle});
        return {};
      default:  // STATE
        if (const auto value = wire::decode<bl::Cmd>(message.body);
            value && value->id == 0 && is_flash(value->period, value->dutycycle))
          return [id = model(), value = *value](world::Journal& journal) {
            journal.apply(changes::SwitchLight{id, value.enable != 0});
            journal.apply(changes::FlashLight{id, value.period, value.dutycycle});
            set_color(journal, id, value.color);
          };
        return {};
    }
  }

  bl::Data data_of(const world::World& world, world::KindRow lamp) const override {
    const world::Blinkenlights& lamps = world.blinkenlights;
    return {lamps.enabled[lamp],
            static_cast<float>(lamps.period[lamp]),
            static_cast<float>(lamps.dutycycle[lamp]),
            {}};
  }
};

/// A light that never blinks.
class Lightindicator final : public Light {
 public:
  using Light::Light;

  std::span<const Served> served() const override {
    static constexpr Served kServed[] = {
        {MessageType::kCmd, bl::kCmdPower},
        {MessageType::kCmd, bl::kCmdColor},
    };
    return kServed;
  }

 private:
  run::Request meaning(const device::Message& message) const override {
    if (message.subtype == bl::kCmdColor) return color(message);
    const auto value = wire::decode<bl::CmdPower>(message.body);
    if (!value || value->id != 0) return {};
    return [change = changes::SwitchIndicator{model(), value->enable != 0}](world::Journal& journal) {
      journal.apply(change);
    };
  }

  bl::Data data_of(const world::World& world, world::KindRow light) const override {
    return {world.lightindicators.lit[light], 0, 1, {}};
  }
};

}  // namespace

std::unique_ptr<SimulatedDevice> make_blinkenlight_device(run::Simulation& simulation,
                                                          world::ModelRow model) {
  return std::make_unique<Blinkenlight>(simulation, model);
}

std::unique_ptr<SimulatedDevice> make_lightindicator_blinkenlight_device(run::Simulation& simulation,
                                                                         world::ModelRow model) {
  return std::make_unique<Lightindicator>(simulation, model);
}

}  // namespace playhouse::drivers
