#pragma once

/// Forwarder: base of algorithms in front of one device of the same interface: commands, requests and data are those
/// of that device, but for what a subclass makes of them.

#include <cstddef>
#include <optional>
#include <vector>

#include "playhouse/drivers/algorithm/shell.h"

namespace playhouse::drivers {

class Forwarder : public Algorithm {
 public:
  /// The device is the first one that is used.
  explicit Forwarder(Shell& shell);

  void take_news(std::vector<device::Publication>& more) override;

 protected:
  /// A command to the first device that the driver provides.
  virtual device::Taken take(const device::Message& message) { return forward(message); }
  /// What becomes of a message of the device; none: it ends here. Publishing thread.
  virtual std::optional<device::Publication> passed(device::Publication message) { return message; }

  device::Taken forward(const device::Message& message) {
    return shell_.client().command(kForwarded, message.subtype, message.body);
  }

  static constexpr std::size_t kForwarded = 0;  // used device

  Shell& shell_;

 private:
  device::Subscription& data_;
};

}  // namespace playhouse::drivers
