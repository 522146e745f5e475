#pragma once

/// Lamps that can be switched, colored and made to flash.

#include <array>
#include <cstdint>
#include <optional>

#include "playhouse/wire/generated/blinkenlight.h"
#include "playhouse_client/client.h"

namespace playhouse::client {

/// Red, green, blue, 0 to 255.
using Rgb = std::array<std::uint8_t, 3>;

/// Settings of a lamp.
struct LightState {
  bool on = false;        // also between two flashes
  double period = 0;      // of its flashes [s]; 0: steady light
  double duty_cycle = 0;  // fraction of the period in which it is lit
  Rgb color{};
  double time = 0;  // the server's, of these data [s]
};

/// Lamps are numbered from 0; a simulated device has one.
class BlinkenLight {
 public:
  static Result<BlinkenLight> open(Client& client, std::uint16_t index, Access access = Access::kAll);

  /// The newest state; none before the first data.
  std::optional<LightState> state() const;

  // Commands: an error, and nothing is sent, if a number is not finite or exceeds the range of float.

  /// set_power(), flash() and set_color() at once.
  Result<void> set(bool on, double period, double duty_cycle, const Rgb& color, std::uint16_t light = 0);
  Result<void> set_power(bool on, std::uint16_t light = 0);
  Result<void> set_color(const Rgb& color, std::uint16_t light = 0);
  /// Lets a lamp that is on flash: lit for this fraction of the period [s], from 0 to 1; a period of 0 is
  /// steady light.
  Result<void> flash(double period, double duty_cycle = 0.5, std::uint16_t light = 0);

  Device& device() { return device_; }

 private:
  friend class Robot;
  explicit BlinkenLight(Device device) : device_(std::move(device)) {}

  Device device_;
};

}  // namespace playhouse::client
