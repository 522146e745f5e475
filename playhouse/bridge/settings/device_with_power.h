#pragma once

#include <span>

#include "playhouse/bridge/settings/settings.h"

namespace playhouse::drivers {

struct PowerSettings {
  bool power = true;
};

/// A device of which clients set nothing but whether it publishes, also by the property "power".
class DeviceWithPower : public DeviceWithSettings<PowerSettings> {
 public:
  DeviceWithPower(run::Simulation& simulation, world::ModelId model)
      : DeviceWithSettings(simulation, model, PowerSettings{}) {}

 private:
  std::span<const NamedSetting> named() const final {
    static constexpr NamedSetting kNamed[] = {{"power", &PowerSettings::power}};
    return kNamed;
  }
  bool settle(PowerSettings&) const final { return true; }
};

}  // namespace playhouse::drivers
