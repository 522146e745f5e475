#include "playhouse_client/blinkenlight.h"

#include <utility>

#include "finite.h"

namespace playhouse::client {

namespace bl = wire::blinkenlight;

namespace {

wire::Color color_of(const Rgb& color) {
  constexpr std::uint8_t kOpaque = 255;
  return {kOpaque, color[0], color[1], color[2]};
}

}  // namespace

Result<BlinkenLight> BlinkenLight::open(Client& client, std::uint16_t index, Access access) {
  Result<Device> device = Device::open(client, bl::kCode, index, access);
  if (!device) return device.error();
  return BlinkenLight(std::move(*device));
}

std::optional<LightState> BlinkenLight::state() const {
  const auto data = device_.latest<bl::Data>(bl::kDataState);
  if (!data) return std::nullopt;
  return LightState{data->enable != 0,
                    data->period,
                    data->dutycycle,
                    {data->color.red, data->color.green, data->color.blue},
                    device_.timestamp()};
}

Result<void> BlinkenLight::set(bool on, double period, double duty_cycle, const Rgb& color,
                               std::uint16_t light) {
  if (const auto sound = finite_floats(device_, "set", {period, duty_cycle}); !sound) return sound;
  return device_.command(bl::kCmdState,
                         bl::Cmd{light, static_cast<std::uint8_t>(on), static_cast<float>(period),
                                 static_cast<float>(duty_cycle), color_of(color)});
}

Result<void> BlinkenLight::set_power(bool on, std::uint16_t light) {
  return device_.command(bl::kCmdPower, bl::CmdPower{light, static_cast<std::uint8_t>(on)});
}

Result<void> BlinkenLight::set_color(const Rgb& color, std::uint16_t light) {
  return device_.command(bl::kCmdColor, bl::CmdColor{light, color_of(color)});
}

Result<void> BlinkenLight::flash(double period, double duty_cycle, std::uint16_t light) {
  if (const auto sound = finite_floats(device_, "flash", {period, duty_cycle}); !sound) return sound;
  return device_.command(bl::kCmdFlash,
                         bl::CmdFlash{light, static_cast<float>(period), static_cast<float>(duty_cycle)});
}

}  // namespace playhouse::client
