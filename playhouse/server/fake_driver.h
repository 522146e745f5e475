#pragma once

/// Fake driver for tests of this module: scripted replies, recorded messages.

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "playhouse/device/driver.h"

namespace playhouse::server {

class FakeDriver final : public device::Driver {
 public:
  explicit FakeDriver(std::string name = "fake") : name_(std::move(name)) {}

  /// ACK bodies by subtype of the request; other requests get NACK.
  std::map<std::uint8_t, std::vector<std::byte>> answers;
  /// A NACK carries the body of the request, as the original's "dummy" driver does.
  std::optional<std::uint8_t> ignored_command;
  bool bounces = false, fails_to_start = false, holds_requests = false, capable_of_all = false,
       holds_barriers = false;

  int starts = 0, stops = 0, lost_holds = 0;
  std::vector<std::pair<std::uint8_t, std::vector<std::byte>>> commands;  // subtype, body
  int requests = 0;
  std::vector<device::Replier> held;
  std::vector<device::Replier> barriers;  // held
  std::function<void()> on_request = [] {};
  std::function<void(device::Caller&)> on_caller;

  std::string unprepared;  // why it is not ready; empty: it is
  std::vector<Prepared> preparing;
  void prepare_now() {
    unprepared.clear();
    for (const Prepared& heard : std::exchange(preparing, {})) heard({});
  }
  void refuse_now() {
    for (const Prepared& heard : std::exchange(preparing, {})) heard(Error{"", unprepared});
  }

  std::string_view name() const override { return name_; }
  bool ready(device::DeviceId) const override { return unprepared.empty(); }
  void prepare(device::DeviceId, Prepared heard) override { preparing.push_back(std::move(heard)); }
  Result<void> start(device::DeviceId) override {
    if (fails_to_start) return Error{"/dev/none", "no such device"};
    ++starts;
    return {};
  }
  void stop(device::DeviceId) override { ++stops; }
  device::Taken command(const device::Message& message) override {
    if (ignored_command == message.subtype) return device::Taken::kNo;
    commands.emplace_back(message.subtype, std::vector(message.body.begin(), message.body.end()));
    return device::Taken::kLatest;
  }
  void request(const device::Message& message, device::Replier replier) override {
    ++requests;
    on_request();
    if (on_caller && message.caller != nullptr) on_caller(*message.caller);
    if (holds_requests) return held.push_back(std::move(replier));
    if (bounces) return replier.nack({message.body.begin(), message.body.end()});
    if (const auto found = answers.find(message.subtype); found != answers.end()) replier.ack(found->second);
  }
  bool capable(device::DeviceId, std::uint8_t, std::uint8_t) const override { return capable_of_all; }
  void retired(device::DeviceId) override { ++lost_holds; }
  void barrier(device::Replier replier) override {
    if (holds_barriers) return barriers.push_back(std::move(replier));
    replier.ack();
  }

 private:
  std::string name_;
};

}  // namespace playhouse::server
