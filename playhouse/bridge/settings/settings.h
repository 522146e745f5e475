#pragma once

/// Settings: what clients have set of a simulated device. They are of the device and not of the world: they shape
/// what it publishes, so that a run and its hash are the same whatever is set, and end when the last client
/// closes it. One struct has them; requests of the interface set several at once, properties single ones by name.
/// Thread: the tick thread between ticks; emit() reads them.

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>

#include "playhouse/bridge/simulated/simulated_device.h"

namespace playhouse::drivers {

/// A device whose settings are `Values`.
template <typename Values>
class DeviceWithSettings : public SimulatedDevice {
 public:
  /// `usual` holds until a client sets something.
  DeviceWithSettings(run::Simulation& simulation, world::ModelId model, Values usual)
      : SimulatedDevice(simulation, model), usual_(std::move(usual)), settings_(usual_) {}

  std::optional<SettingValue> setting(std::string_view name) const override {
    for (const NamedSetting& each : named())
      if (each.name == name) {
        return std::visit([&](const auto member) { return SettingValue(settings_.*member); }, each.member);
      }
    return std::nullopt;
  }
  bool set_setting(std::string_view name, const SettingValue& value) override {
    for (const NamedSetting& each : named())
      if (each.name == name) {
        return change([&](Values& wanted) {
          return std::visit(
              [&](const auto member) {
                const auto* given = std::get_if<std::remove_cvref_t<decltype(wanted.*member)>>(&value);
                if (given != nullptr) wanted.*member = *given;
                return given != nullptr;
              },
              each.member);
        });
      }
    return false;
  }
  void ended(world::Journal&) override { put(usual_); }

 protected:
  /// A setting as a property, by the name of its field in the interface's definition.
  struct NamedSetting {
    std::string_view name;
    std::variant<bool Values::*, std::int32_t Values::*, double Values::*, std::string Values::*> member;
  };
  virtual std::span<const NamedSetting> named() const { return {}; }
  /// Turns wanted values into those in effect; false if they are invalid.
  virtual bool settle(Values& wanted) const = 0;
  /// Called after each change.
  virtual void settled() {}

  const Values& settings() const { return settings_; }
  const Values& usual() const { return usual_; }

  /// edit(wanted) of a copy of the settings; without effect if it or settle() is false.
  template <typename Edit>
  bool change(const Edit& edit) {
    Values wanted = settings_;
    if (!edit(wanted) || !settle(wanted)) return false;
    put(std::move(wanted));
    return true;
  }
  /// The same for a request, whose ACK has the body answer(settings).
  template <typename Edit, typename Answer>
  void change_settings(device::Replier replier, Edit edit, Answer answer) {
    answer_by(std::move(replier),
              [self = shared_from_this(), this, edit = std::move(edit),
               answer = std::move(answer)](world::Journal&) -> std::optional<Bytes> {
                if (!change(edit)) return std::nullopt;
                return answer(settings_);
              });
  }
  template <typename Edit>
  void change_settings(device::Replier replier, Edit edit) {
    change_settings(std::move(replier), std::move(edit), [](const Values&) { return Bytes(); });
  }
  /// Answers with them, after all earlier changes.
  template <typename Answer>
  void tell_settings(device::Replier replier, Answer answer) {
    answer_by(std::move(replier), [self = shared_from_this(), this, answer = std::move(answer)](
                                      world::Journal&) { return std::optional<Bytes>(answer(settings_)); });
  }

 private:
  void put(Values values) {
    settings_ = std::move(values);
    settled();
  }

  const Values usual_;
  Values settings_;
};

}  // namespace playhouse::drivers
