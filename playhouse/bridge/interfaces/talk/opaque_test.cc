// Messages of radios as bytes of interface opaque, checked against the world's columns.

#include "playhouse/wire/generated/opaque.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <span>

#include "playhouse/base/limits.h"
#include "playhouse/bridge/simulated/device_factory.h"
#include "playhouse/bridge/simulated/simulated_driver.h"
#include "playhouse/bridge/testing/still_devices.h"
#include "playhouse/world/radio_messages.h"

namespace playhouse::drivers {
namespace {

namespace op = wire::opaque;
using wire::MessageType;

constexpr const char* kWorld = R"(
position( name "r0" wifi( name "radio" ) )
wifi( name "post" ip "192.168.0.9" )
wifi( name "next" )
)";

std::vector<std::uint8_t> bytes_of(std::string_view text) {
  return {text.begin(), text.end()};
}

class OpaqueDevice : public ::testing::Test {
 protected:
  OpaqueDevice() {
    driver_.add(kId, make_device(still_.devices, op::kCode, world().find("r0.radio")));
    EXPECT_TRUE(driver_.start(kId));
    still_.run(0);
  }
  world::World& world() { return still_.world(); }
  device::Taken command(std::string_view text) {
    const std::vector<std::byte> body = wire::encode(op::Data{bytes_of(text)});
    const device::Taken taken =
        driver_.command({kId, static_cast<std::uint8_t>(MessageType::kCmd), op::kCmdData, body});
    still_.run(0);
    return taken;
  }
  /// Whether it was acknowledged.
  bool ask(std::string_view text) {
    const std::vector<std::byte> body = wire::encode(op::Data{bytes_of(text)});
    driver_.request({kId, static_cast<std::uint8_t>(MessageType::kReq), op::kReqData, body},
                    device::Replier(still_.recorder, ++ticket_));
    still_.run(0);
    EXPECT_TRUE(still_.recorder.answers.contains(ticket_));
    return still_.recorder.answers[ticket_].ack;
  }
  /// What waits to be sent: "all:hello post:hi ".
  std::string sent() {
    std::string all;
    world::each_message(world::outgoing_of(world().wifis, {0}), [&](const auto& message, auto bytes) {
      all += (message.station ? world().name(world().row(message.station)) : "all") + ":" +
             std::string(bytes.begin(), bytes.end()) + " ";
    });
    return all;
  }

  static constexpr device::DeviceId kId{3};
  testing::StillDevices still_{kWorld};
  SimulatedDriver driver_{still_.devices, "stage"};
  std::uint64_t ticket_ = 0;
};

TEST_F(OpaqueDevice, a_command_is_a_message_to_all_byte_for_byte) {
  EXPECT_EQ(command("hello"), device::Taken::kQueued);
  EXPECT_EQ(command(std::string_view("\0\xff", 2)), device::Taken::kQueued);
  EXPECT_EQ(sent(), std::string("all:hello all:\0\xff ", 17));
}

TEST_F(OpaqueDevice, a_request_is_a_message_to_the_radio_of_that_address) {
  EXPECT_TRUE(ask(std::string_view("192.168.0.9\0hi", 14)));
  const std::uint32_t next = world().id(world().find("next")).value;
  EXPECT_TRUE(ask("10.0.0." + std::to_string(next) + std::string(1, '\0') + "you"));
  EXPECT_TRUE(ask(std::string_view("\0everybody", 10)));
  EXPECT_EQ(sent(), "post:hi next:you all:everybody ");
}

TEST_F(OpaqueDevice, refuses_a_request_to_nobody) {
  EXPECT_FALSE(ask(std::string_view("192.168.0.8\0hi", 14))) << "there is no such radio";
  EXPECT_FALSE(ask("192.168.0.9")) << "the address has no end";
  EXPECT_FALSE(ask(""));
  EXPECT_EQ(sent(), "");
}

TEST_F(OpaqueDevice, sends_no_message_that_is_too_long_and_none_beyond_its_room) {
  EXPECT_EQ(command(std::string(limits::kRadioMessageBytes + 1, 'x')), device::Taken::kNo);
  EXPECT_FALSE(ask(std::string(1, '\0') + std::string(limits::kRadioMessageBytes + 1, 'x')));
  for (std::size_t i = 0; i < limits::kRadioSends; ++i) EXPECT_EQ(command("x"), device::Taken::kQueued);
  EXPECT_FALSE(ask(std::string_view("192.168.0.9\0hi", 14)));
  EXPECT_EQ(world().wifis.outgoing[{0}].size(), limits::kRadioSends);
  EXPECT_EQ(world().wifis.dropped[{0}], 1u);
}

TEST_F(OpaqueDevice, each_message_that_arrived_in_a_tick_is_data_of_its_bytes) {
  world::receive_message(world().wifis, {0}, world().id(world().find("post")), bytes_of("four"));
  world::receive_message(world().wifis, {0}, world().id(world().find("next")), {});
  still_.run(1);
  ASSERT_EQ(still_.recorder.published.size(), 2u);
  const auto& first = still_.recorder.published[0];
  EXPECT_EQ(first.subtype, op::kDataState);
  EXPECT_EQ(first.device, kId);
  const auto wire = std::as_bytes(std::span("\0\0\0\4\0\0\0\4four", 12));
  EXPECT_TRUE(std::ranges::equal(first.body, wire));
  EXPECT_EQ(wire::decode<op::Data>(still_.recorder.published[1].body)->data.size(), 0u);
}

TEST_F(OpaqueDevice, drops_what_is_no_command) {
  const std::byte cut[3] = {};
  EXPECT_EQ(driver_.command({kId, static_cast<std::uint8_t>(MessageType::kCmd), op::kCmdData, cut}),
            device::Taken::kNo);
  EXPECT_EQ(sent(), "");
}

}  // namespace
}  // namespace playhouse::drivers
