#include "playhouse_client/power.h"

#include <utility>

#include "done.h"

namespace playhouse::client {

namespace power = wire::power;

namespace {

Charging charging_of(std::int32_t value) {
  if (value < 0) return Charging::kImpossible;
  return value > 0 ? Charging::kYes : Charging::kNo;
}

}  // namespace

Result<Power> Power::open(Client& client, std::uint16_t index, Access access) {
  Result<Device> device = Device::open(client, power::kCode, index, access);
  if (!device) return device.error();
  return Power(std::move(*device));
}

std::optional<PowerState> Power::state() const {
  const auto data = device_.latest<power::Data>(power::kDataState);
  if (!data) return std::nullopt;
  PowerState state;
  if ((data->valid & power::kMaskVolts) != 0) state.volts = data->volts;
  if ((data->valid & power::kMaskPercent) != 0) state.percent = data->percent;
  if ((data->valid & power::kMaskJoules) != 0) state.joules = data->joules;
  if ((data->valid & power::kMaskWatts) != 0) state.watts = data->watts;
  if ((data->valid & power::kMaskCharging) != 0) state.charging = charging_of(data->charging);
  state.time = device_.timestamp();
  return state;
}

Result<void> Power::set_charging_policy(bool takes, bool gives) {
  const power::ChargepolicyConfig policy{static_cast<std::uint8_t>(takes), static_cast<std::uint8_t>(gives)};
  return done(device_.request(power::kReqSetChargingPolicy, policy));
}

}  // namespace playhouse::client
