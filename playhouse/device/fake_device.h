#pragma once

/// Fakes for tests of this module: a driver that records messages, and recorders of outputs.

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "playhouse/device/client.h"

namespace playhouse::device {

inline std::vector<std::byte> bytes(std::string_view text) {
  const auto raw = std::as_bytes(std::span(text));
  return {raw.begin(), raw.end()};
}

inline std::string text(std::span<const std::byte> bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

/// Echoes every request, except subtype 9, which gets NACK.
class FakeDevice final : public Driver {
 public:
  std::vector<std::string> commands;
  std::vector<Replier> barriers;
  bool broken = false;

  std::string_view name() const override { return "fake"; }
  Result<void> start(DeviceId) override {
    return broken ? Result<void>(Error{"", "no hardware"}) : Result<void>();
  }
  void stop(DeviceId) override {}
  Taken command(const Message& message) override {
    commands.push_back(text(message.body));
    return Taken::kQueued;
  }
  void request(const Message& message, Replier replier) override {
    if (message.subtype == 9) return;
    replier.ack({message.body.begin(), message.body.end()});
  }
  bool capable(DeviceId, std::uint8_t, std::uint8_t subtype) const override { return subtype != 9; }
  void barrier(Replier replier) override { barriers.push_back(std::move(replier)); }
};

/// Devices 0, 1, 2 ... with a driver each, and hold counts.
struct FakeDevices final : Opener {
  std::map<std::uint32_t, FakeDevice> drivers;
  std::map<std::uint32_t, int> held;
  std::map<std::uint32_t, Driver*> holders;  // last holder of each
  Result<void> hold(DeviceId device, Driver* holder) override {
    if (const Result<void> started = drivers[device.row].start(device); !started) return started;
    ++held[device.row];
    holders[device.row] = holder;
    return {};
  }
  void release(DeviceId device, Driver*) override { --held[device.row]; }
};

/// Records published messages as "row.subtype body".
struct FakePublisher final : Publisher {
  std::vector<std::string> lines;
  void publish(std::vector<Publication> batch) override {
    for (const Publication& publication : batch)
      lines.push_back(std::to_string(publication.device.row) + "." + std::to_string(publication.subtype) +
                      " " + text(publication.body));
  }
};

/// Records replies by ticket: the body, or "NACK".
struct FakeOutlet final : Outlet {
  std::map<std::uint64_t, std::string> answers;
  void answer(std::uint64_t ticket, bool ack, std::vector<std::byte> body) override {
    answers[ticket] = ack ? text(body) : "NACK";
  }
};

}  // namespace playhouse::device
