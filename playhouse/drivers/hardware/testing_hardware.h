#pragma once

/// For tests of drivers of hardware and their emulators: a server whose serial lines are simulated cables, devices that are
/// only told things, and a far end of a line that is a script.

#include <gtest/gtest.h>

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "playhouse/bridge/testing/memory_site.h"
#include "playhouse/drivers/hardware/bytes.h"
#include "playhouse/drivers/site.h"
#include "playhouse/net/simulated.h"
#include "playhouse/server/fake_driver.h"
#include "playhouse/server/server.h"
#include "playhouse/server/test_client.h"

namespace playhouse::drivers::testing {

/// "fa fb 03" as bytes, and back.
inline RawBytes from_hex(std::string_view text) {
  RawBytes bytes;
  const auto value = [](char digit) { return digit <= '9' ? digit - '0' : digit - 'a' + 10; };
  for (std::size_t at = 0; at + 1 < text.size(); at += 3)
    put_u8(bytes, value(text[at]) * 16 + value(text[at + 1]));
  return bytes;
}
inline std::string to_hex(std::span<const std::byte> bytes) {
  std::string text;
  for (const std::byte byte : bytes)
    text += fmt::format("{}{:02x}", text.empty() ? "" : " ", static_cast<int>(byte));
  return text;
}

/// Hardware that is a script, at a simulated cable.
class FarEnd final : private net::SerialEvents {
 public:
  FarEnd(net::SimulatedNetwork& network, const std::string& name, const net::SerialSettings& settings = {})
      : network_(network), line_(*network.open_terminal(name, settings)) {
    line_->start(*this);
  }
  void send(std::span<const std::byte> bytes) { line_->send(bytes); }
  /// What came within so long, and before.
  RawBytes take(double seconds = 0.1) {
    network_.run_for(seconds);
    return std::exchange(bytes_, {});
  }

 private:
  void received(std::span<const std::byte> bytes) override {
    bytes_.insert(bytes_.end(), bytes.begin(), bytes.end());
  }
  void ended(const std::string&) override {}

  net::SimulatedNetwork& network_;
  std::unique_ptr<net::SerialLine> line_;
  RawBytes bytes_;
};

class HardwareTest : public ::testing::Test, public Host {
 protected:
  static constexpr std::uint16_t kPort = 6665;

  HardwareTest() {
    site.data_flow().pass_to(server);
    EXPECT_TRUE(server.listen(kPort));
  }
  // As programs end: whoever waits is answered while the server is there.
  ~HardwareTest() override {
    for (const auto& driver : drivers) driver->finish();
  }

  /// "", or the error's line.
  std::string build(const std::string& cfg) {
    const std::string error = build_drivers(cfg, site, drivers);
    if (error.empty()) network_.run();
    return error;
  }
  /// A device that is only told things, before the drivers are built.
  server::FakeDriver& add_device(std::uint16_t interf, std::uint16_t index = 0) {
    fakes_.push_back(std::make_unique<server::FakeDriver>("fake"));
    ids_[{interf, index}] = *site.add_device({kPort, interf, index}, *fakes_.back());
    return *fakes_.back();
  }
  /// Data of such a device.
  template <typename T>
  void publish(std::uint16_t interf, std::uint8_t subtype, const T& value, std::uint16_t index = 0) {
    site.data_flow().publish({{ids_.at({interf, index}), subtype, network_.now(), wire::encode(value)}});
  }
  /// A client in push mode, with the device open; the answer is in `access`.
  std::unique_ptr<server::TestClient> client_of(std::uint16_t interf, std::uint16_t index = 0) {
    auto client = std::make_unique<server::TestClient>(network_, kPort);
    client->ask(server::mode_request(1));
    access = server::access_of(client->ask(server::open_request(interf, index)).at(0));
    return client;
  }
  template <typename T>
  static Bytes command(std::uint16_t interf, std::uint8_t subtype, const T& value, std::uint16_t index = 0) {
    return server::message(wire::MessageType::kCmd, interf, index, subtype, wire::encode(value));
  }
  static Bytes bare_command(std::uint16_t interf, std::uint8_t subtype, std::uint16_t index = 0) {
    return server::message(wire::MessageType::kCmd, interf, index, subtype);
  }
  template <typename T>
  static Bytes request(std::uint16_t interf, std::uint8_t subtype, const T& value, std::uint16_t index = 0) {
    return server::message(wire::MessageType::kReq, interf, index, subtype, wire::encode(value));
  }
  static Bytes question(std::uint16_t interf, std::uint8_t subtype, std::uint16_t index = 0) {
    return server::message(wire::MessageType::kReq, interf, index, subtype);
  }
  /// The last data of a kind that the client got within so long; T{} without any.
  template <typename T>
  T latest(server::TestClient& client, std::uint16_t interf, std::uint8_t subtype, double seconds) {
    network_.run_for(seconds);
    T value{};
    for (const server::Received& each : client.read())
      if (each.header.type == wire::MessageType::kData && each.header.interf == interf &&
          each.header.subtype == subtype)
        value = *wire::decode<T>(each.body);
    return value;
  }

  Result<device::DeviceId> add_device(device::Address address, device::Driver& driver) override {
    return server.add_device(address, driver);
  }
  void retire_device(device::DeviceId device) override { server.retire_device(device); }
  Result<void> hold(device::DeviceId device, device::Driver* holder) override {
    return server.hold(device, holder);
  }
  void release(device::DeviceId device, device::Driver* holder) override { server.release(device, holder); }
  void post(std::function<void()> task) override { network_.post(std::move(task)); }
  net::Network& network() override { return network_; }

  net::SimulatedNetwork network_{13};
  std::vector<std::unique_ptr<server::FakeDriver>> fakes_;
  std::map<std::pair<std::uint16_t, std::uint16_t>, device::DeviceId> ids_;
  int access = 0;
  Site site{*this, kPort};
  std::vector<std::unique_ptr<device::Driver>> drivers;
  server::Server server{network_};
};

}  // namespace playhouse::drivers::testing
