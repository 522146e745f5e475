#pragma once

/// A driver of a configuration file between devices that say what a test wants and a client: no world, no thread.

#include <gtest/gtest.h>

#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "playhouse/bridge/testing/memory_site.h"
#include "playhouse/drivers/decoded.h"
#include "playhouse/wire/codec.h"

namespace playhouse::drivers::testing {

/// Devices that answer what was set, and note what they are told.
class ToldDevices final : public device::Driver {
 public:
  struct ToldMessage {
    device::DeviceId device;
    std::uint8_t subtype = 0;
    std::vector<std::byte> body;
  };

  std::string_view name() const override { return "told"; }
  Result<void> start(device::DeviceId) override { return {}; }
  void stop(device::DeviceId) override {}
  device::Taken command(const device::Message& message) override {
    commands.push_back({message.device, message.subtype, {message.body.begin(), message.body.end()}});
    return device::Taken::kLatest;
  }
  void request(const device::Message& message, device::Replier replier) override {
    requests.push_back({message.device, message.subtype, {message.body.begin(), message.body.end()}});
    if (holds) return held.push_back(std::move(replier));
    const auto found = answers.find({message.device.row, message.subtype});
    if (found != answers.end()) replier.ack(found->second);
  }
  bool capable(device::DeviceId device, std::uint8_t, std::uint8_t subtype) const override {
    return answers.contains({device.row, subtype});
  }

  std::map<std::pair<std::uint32_t, std::uint8_t>, std::vector<std::byte>> answers;
  std::vector<ToldMessage> commands, requests;
  bool holds = false;  // requests wait
  std::vector<device::Replier> held;
};

class DriverBench {
 public:
  /// `own`: the driver's device that is opened, of a section that requires `used`.
  DriverBench(const std::string& section, std::vector<device::Address> used, device::Address own)
      : own_(own), site_("") {
    for (const device::Address address : used) EXPECT_TRUE(site_.site().add_device(address, told_));
    EXPECT_EQ(site_.build(section), "");
    EXPECT_TRUE(open());
  }

  bool open() { return site_.hold(site_.id(own_)).ok(); }
  void close() { site_.release(site_.id(own_)); }

  /// From now on a device answers so.
  template <typename T>
  void answers(device::Address address, std::uint8_t subtype, const T& body) {
    told_.answers[{site_.id(address).row, subtype}] = wire::encode(body);
  }
  /// A device publishes.
  template <typename T>
  void says(device::Address address, std::uint8_t subtype, double time, const T& body) {
    site_.site().data_flow().publish({{site_.id(address), subtype, time, wire::encode(body)}});
  }
  /// What the driver published since the last call, of this subtype of its device.
  template <typename T>
  std::vector<T> heard(std::uint8_t subtype) {
    return heard<T>(own_, subtype);
  }
  template <typename T>
  std::vector<T> heard(device::Address address, std::uint8_t subtype) {
    std::vector<T> bodies;
    for (const device::Publication& each : site_.recorder.published)
      if (each.device == site_.id(address) && each.subtype == subtype)
        bodies.push_back(*wire::decode<T>(each.body));
    site_.recorder.published.clear();
    return bodies;
  }
  /// What the devices were commanded since the last call: this subtype of one of them.
  template <typename T>
  std::vector<T> commanded(device::Address address, std::uint8_t subtype) {
    std::vector<T> bodies;
    for (const ToldDevices::ToldMessage& each : told_.commands)
      if (each.device == site_.id(address) && each.subtype == subtype)
        bodies.push_back(*wire::decode<T>(each.body));
    told_.commands.clear();
    return bodies;
  }
  /// The answer to a request; none for NACK.
  AnswerBody ask(std::uint8_t subtype, const std::vector<std::byte>& body = {}) {
    return ask(own_, subtype, body);
  }
  AnswerBody ask(device::Address address, std::uint8_t subtype, const std::vector<std::byte>& body = {}) {
    constexpr std::uint8_t kRequest = 3;
    site_.driver(address).request({site_.id(address), kRequest, subtype, body},
                                  device::Replier(site_.recorder, 1));
    const auto& answer = site_.recorder.answers.at(1);
    return answer.ack ? AnswerBody(answer.body) : std::nullopt;
  }
  template <typename T>
  device::Taken command(std::uint8_t subtype, const T& body) {
    return command(own_, subtype, body);
  }
  template <typename T>
  device::Taken command(device::Address address, std::uint8_t subtype, const T& body) {
    constexpr std::uint8_t kCommand = 2;
    const std::vector<std::byte> bytes = wire::encode(body);
    return site_.driver(address).command({site_.id(address), kCommand, subtype, bytes});
  }

  ToldDevices& told() { return told_; }
  MemorySite& site() { return site_; }

 private:
  const device::Address own_;
  ToldDevices told_;
  MemorySite site_;
};

/// The error of a file.
inline std::string fault_of(const std::string& cfg) {
  MemorySite site("");
  return site.build(cfg);
}

}  // namespace playhouse::drivers::testing
