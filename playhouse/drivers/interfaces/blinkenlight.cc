/// A lamp, or a steady light, as interface blinkenlight (docs/drivers.md).

#include <cmath>

#include "playhouse/drivers/generated/device_makers.h"
#include "playhouse/scene/forms/colors.h"
#include "playhouse/wire/generated/blinkenlight.h"
#include "playhouse/world/periods.h"

namespace playhouse::drivers {
namespace {

namespace bl = wire::blinkenlight;
using wire::MessageType;

wire::Color color_of(const scene::Color& color) {
  const std::uint32_t rgba = scene::rgba8(color);
  const auto byte = [rgba](unsigned shift) { return static_cast<std::uint8_t>(rgba >> shift); };
  return {byte(0), byte(24), byte(16), byte(8)};
}

/// Player clients send alpha 0: keeps the model's.
void set_color(world::World& world, world::ModelRow model, const wire::Color& color) {
  world::set_color(world, model,
                   {static_cast<float>(color.red) / 255, static_cast<float>(color.green) / 255,
                    static_cast<float>(color.blue) / 255, world.models.color[model.index].a});
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
    const Setting setting = meaning(message);
    if (!setting) return device::Taken::kNo;
    const auto change = [id = model(), setting](world::World& world) {
      if (const world::ModelRow row = world.row(id)) setting(world, row);
    };
    return simulation().post(change, model()) ? device::Taken::kQueued : device::Taken::kNo;
  }

  void emit(const world::World& world, std::vector<device::Publication>& out) final {
    if (world.tick() % update_ticks_ != 0) return;
    const world::ModelRow row = world.row(model());
    if (!row) return;
    bl::Data data = data_of(world, world.models.part[row.index]);
    data.color = color_of(world.models.color[row.index]);
    publish(world, bl::kDataState, data, out);
  }

 protected:
  using Setting = std::function<void(world::World&, world::ModelRow)>;

  /// The setting that a command requests; empty if invalid. The only light has number 0.
  virtual Setting meaning(const device::Message& message) const = 0;
  /// Data of row `light` of its table.
  virtual bl::Data data_of(const world::World& world, std::uint32_t light) const = 0;

  static Setting color(const device::Message& message) {
    const auto value = wire::decode<bl::CmdColor>(message.body);
    if (!value || value->id != 0) return {};
    return [color = value->color](auto& world, auto row) { set_color(world, row, color); };
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
  static void power(world::World& world, world::ModelRow row, bool on) {
    world.blinkenlights.enabled[world.models.part[row.index]] = on;
  }
  static void flash(world::World& world, world::ModelRow row, double period, double dutycycle) {
    const std::uint32_t lamp = world.models.part[row.index];
    world.blinkenlights.period[lamp] = period;
    world.blinkenlights.dutycycle[lamp] = dutycycle;
  }

  Setting meaning(const device::Message& message) const override {
    switch (message.subtype) {
      case bl::kCmdColor:
        return color(message);
      case bl::kCmdPower:
        if (const auto value = wire::decode<bl::CmdPower>(message.body); value && value->id == 0)
          return [on = value->enable != 0](auto& world, auto row) { power(world, row, on); };
        return {};
      case bl::kCmdFlash:
        if (const auto value = wire::decode<bl::CmdFlash>(message.body);
            value && value->id == 0 && is_flash(value->period, value->dutycycle))
          return
              [value = *value](auto& world, auto row) { flash(world, row, value.period, value.dutycycle); };
        return {};
      default:  // STATE
        if (const auto value = wire::decode<bl::Cmd>(message.body);
            value && value->id == 0 && is_flash(value->period, value->dutycycle))
          return [value = *value](auto& world, auto row) {
            power(world, row, value.enable != 0);
            flash(world, row, value.period, value.dutycycle);
            set_color(world, row, value.color);
          };
        return {};
    }
  }

  bl::Data data_of(const world::World& world, std::uint32_t lamp) const override {
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
  Setting meaning(const device::Message& message) const override {
    if (message.subtype == bl::kCmdColor) return color(message);
    const auto value = wire::decode<bl::CmdPower>(message.body);
    if (!value || value->id != 0) return {};
    return [on = value->enable != 0](auto& world, auto row) {
      world.lightindicators.lit[world.models.part[row.index]] = on;
    };
  }

  bl::Data data_of(const world::World& world, std::uint32_t light) const override {
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
