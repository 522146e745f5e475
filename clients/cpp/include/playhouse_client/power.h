#pragma once

/// Battery.

#include <cstdint>
#include <optional>

#include "playhouse/wire/generated/power.h"
#include "playhouse_client/client.h"

namespace playhouse::client {

/// Whether a battery is being charged.
enum class Charging : std::int8_t { kImpossible = -1, kNo = 0, kYes = 1 };

/// State of a battery; what the server does not report is empty.
struct PowerState {
  std::optional<double> volts;    // V
  std::optional<double> percent;  // of a full charge
  std::optional<double> joules;   // J
  std::optional<double> watts;    // W, drawn; negative while charging
  std::optional<Charging> charging;
  double time = 0;  // the server's, of these data [s]
};

class Power {
 public:
  static Result<Power> open(Client& client, std::uint16_t index, Access access = Access::kAll);

  /// The newest state; none before the first data.
  std::optional<PowerState> state() const;

  /// Whether the battery may be charged, and whether it may supply others.
  Result<void> set_charging_policy(bool takes, bool gives);

  Device& device() { return device_; }

 private:
  friend class Robot;
  explicit Power(Device device) : device_(std::move(device)) {}

  Device device_;
};

}  // namespace playhouse::client
