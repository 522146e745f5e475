/// A lamp as interface blinkenlight (docs/drivers.md).

#include <cmath>

#include "playhouse/drivers/generated/device_makers.h"
#include "playhouse/scene/colors.h"
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

/// Player's clients leave the alpha at 0: the model keeps its own.
void set_color(world::World& world, world::ModelRow model, const wire::Color& color) {
  world::set_color(world, model,
                   {static_cast<float>(color.red) / 255, static_cast<float>(color.green) / 255,
                    static_cast<float>(color.blue) / 255, world.models.color[model.index].a});
}

/// Numbers of a flash that can be made.
bool is_flash(float period, float dutycycle) {
  return std::isfinite(period) && period >= 0 && dutycycle >= 0 && dutycycle <= 1;
}

class Blinkenlight final : public SimulatedDevice {
 public:
  Blinkenlight(Simulation& simulation, world::ModelRow model)
      : SimulatedDevice(simulation, simulation.world().id(model)),
        update_ticks_(world::update_ticks(simulation.world(), model)) {}

  std::span<const Served> served() const override {
    static constexpr Served kServed[] = {
        {MessageType::kCmd, bl::kCmdState},
        {MessageType::kCmd, bl::kCmdPower},
        {MessageType::kCmd, bl::kCmdColor},
        {MessageType::kCmd, bl::kCmdFlash},
    };
    return kServed;
  }
  void request(const device::Message&, device::Replier) override {}

  /// Each command sets another part of the lamp, so none replaces another that waits.
  device::Taken command(const device::Message& message) override {
    const Setting setting = meaning(message);
    if (!setting) return device::Taken::kNo;
    const auto change = [id = model(), setting](world::World& world) {
      if (const world::ModelRow row = world.row(id)) setting(world, row);
    };
    return simulation().post(change, model()) ? device::Taken::kQueued : device::Taken::kNo;
  }

  void emit(const world::World& world, std::vector<device::Publication>& out) override {
    if (world.tick() % update_ticks_ != 0) return;
    const world::ModelRow row = world.row(model());
    if (!row) return;
    const world::Blinkenlights& lamps = world.blinkenlights;
    const std::uint32_t lamp = world.models.part[row.index];
    publish(world, bl::kDataState,
            bl::Data{lamps.enabled[lamp], static_cast<float>(lamps.period[lamp]),
                     static_cast<float>(lamps.dutycycle[lamp]), color_of(world.models.color[row.index])},
            out);
  }

 private:
  using Setting = std::function<void(world::World&, world::ModelRow)>;

  static void flash(world::World& world, world::ModelRow row, double period, double dutycycle) {
    const std::uint32_t lamp = world.models.part[row.index];
    world.blinkenlights.period[lamp] = period;
    world.blinkenlights.dutycycle[lamp] = dutycycle;
  }
  static void power(world::World& world, world::ModelRow row, bool on) {
    world.blinkenlights.enabled[world.models.part[row.index]] = on;
  }

  /// What a command means; empty if it makes no sense. There is one lamp, of number 0.
  static Setting meaning(const device::Message& message) {
    switch (message.subtype) {
      case bl::kCmdPower:
        if (const auto value = wire::decode<bl::CmdPower>(message.body); value && value->id == 0)
          return [on = value->enable != 0](auto& world, auto row) { power(world, row, on); };
        return {};
      case bl::kCmdColor:
        if (const auto value = wire::decode<bl::CmdColor>(message.body); value && value->id == 0)
          return [color = value->color](auto& world, auto row) { set_color(world, row, color); };
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

  std::uint64_t update_ticks_;
};

}  // namespace

std::unique_ptr<SimulatedDevice> make_blinkenlight_device(Simulation& simulation, world::ModelRow model) {
  return std::make_unique<Blinkenlight>(simulation, model);
}

}  // namespace playhouse::drivers
