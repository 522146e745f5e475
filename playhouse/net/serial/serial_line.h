#pragma once

/// SerialLine: one end of a serial line, to hardware at a port of this machine (Network::open_serial), or of a
/// pseudo-terminal at which another program finds what behaves as hardware (Network::open_terminal). Raw bytes of 8 bits
/// without flow control: what one end does not take in time is lost. Io thread.

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include "playhouse/base/result.h"

namespace playhouse::net {

enum class SerialParity : std::uint8_t { kNone, kEven, kOdd };

struct SerialSettings {
  int baud = 9600;
  SerialParity parity = SerialParity::kNone;
  int stop_bits = 1;  // or 2

  friend bool operator==(const SerialSettings&, const SerialSettings&) = default;
};

/// Callbacks of a line.
class SerialEvents {
 public:
  virtual ~SerialEvents() = default;
  /// Bytes in order of arrival; `bytes` is valid during the call.
  virtual void received(std::span<const std::byte> bytes) = 0;
  /// Nothing comes any more: the port was unplugged. Called at most once, the last event.
  virtual void ended(const std::string& why) = 0;
};

/// The destructor closes the line at once, without further events; it may be destroyed inside an event.
class SerialLine {
 public:
  virtual ~SerialLine() = default;
  /// Starts reading. `events` must outlive the line.
  virtual void start(SerialEvents& events) = 0;
  /// Sends in order, as fast as the line takes it. What would exceed limits::kSerialBytes of waiting bytes is lost as a whole;
  /// of a terminal the oldest of them are.
  virtual void send(std::span<const std::byte> bytes) = 0;
  /// Changes how bytes travel from now on.
  virtual Result<void> set(const SerialSettings& settings) = 0;
  /// Of the end that another program has opened, for a terminal; else as it was set.
  virtual SerialSettings settings() const = 0;
  /// Drops what has arrived and was not received.
  virtual void drop_input() = 0;
  /// "/dev/ttyUSB0"
  virtual const std::string& name() const = 0;
};

}  // namespace playhouse::net
