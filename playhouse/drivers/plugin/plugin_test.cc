// Drivers of shared libraries, by way of a configuration file: testing/libraries/probe.cc.

#include "playhouse/drivers/plugin/plugin.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <string>
#include <vector>

#include "playhouse/bridge/testing/memory_site.h"
#include "playhouse/wire/codec.h"
#include "playhouse/wire/generated/aio.h"
#include "playhouse/wire/generated/opaque.h"
#include "playhouse/wire/header.h"

namespace playhouse::drivers {
namespace {

namespace aio = wire::aio;
namespace op = wire::opaque;
using ::testing::ElementsAre;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using testing::MemorySite;

constexpr std::uint8_t kCmd = static_cast<std::uint8_t>(wire::MessageType::kCmd);
constexpr std::uint8_t kReq = static_cast<std::uint8_t>(wire::MessageType::kReq);
constexpr device::Address kAio{6665, aio::kCode, 0}, kOwn{6665, op::kCode, 0}, kOther{6665, op::kCode, 1};

const std::string kRelay = "driver ( name \"relay\" provides [\"opaque:1\"] )\n";
const std::string kUses = " requires [\"opaque:1\"]";

op::Data bytes_of(const std::string& text) {
  return {{text.begin(), text.end()}};
}

/// In this process, and in one of its own: nobody sees which.
class PluginTest : public ::testing::TestWithParam<bool> {
 protected:
  PluginTest() { setenv("PLAYHOUSE_PATH", TEST_LIBRARIES, 1); }
  ~PluginTest() override { unsetenv("PLAYHOUSE_PATH"); }

  static std::string section(const std::string& more = "") {
    return R"(driver ( name "probe" plugin "probe" provides ["aio:0" "opaque:0"] )" + more +
           (GetParam() ? " isolated 1" : "") + " )\n";
  }
  void build(const std::string& cfg) { ASSERT_EQ(site_.build(cfg), ""); }
  template <typename T>
  device::Taken command(device::Address address, std::uint8_t subtype, const T& value) {
    const std::vector<std::byte> body = wire::encode(value);
    return site_.driver(address).command({site_.id(address), kCmd, subtype, body});
  }
  testing::OutputRecorder::RecordedAnswer ask(device::Address address, std::uint8_t subtype,
                                              const op::Data& value) {
    const std::vector<std::byte> body = wire::encode(value);
    site_.driver(address).request({site_.id(address), kReq, subtype, body},
                                  device::Replier(site_.recorder, ++ticket_));
    return site_.recorder.answers.at(ticket_);
  }
  /// By this fault, of a plug-in that uses the device of another driver.
  void expect_that_it_loses_its_devices_alone(const std::string& fault) {
    build(kRelay + section(kUses + " fault \"" + fault + "\""));
    ASSERT_TRUE(site_.hold(site_.id(kAio)));
    ASSERT_TRUE(site_.hold(site_.id(kOther)));
    const device::DeviceId aio = site_.id(kAio), own = site_.id(kOwn), other = site_.id(kOther);
    EXPECT_EQ(command(kAio, aio::kCmdState, aio::Cmd{0, 3.5f}), device::Taken::kQueued);
    EXPECT_FALSE(ask(kOwn, op::kReqData, bytes_of("abc")).ack);
    site_.hear();
    site_.hear();
    EXPECT_THAT(site_.retired, ElementsAre(aio.row, own.row));
    EXPECT_EQ(site_.held[other.row].size(), 1u) << "ours; its own hold has ended";
  }
  /// What a device of interface opaque has published, as text.
  std::vector<std::string> said(device::Address address) {
    std::vector<std::string> lines;
    for (const device::Publication& each : site_.recorder.published) {
      if (each.device != site_.id(address)) continue;
      const auto value = wire::decode<op::Data>(each.body);
      lines.emplace_back(value->data.begin(), value->data.end());
    }
    return lines;
  }

  MemorySite site_{"", false};
  std::uint64_t ticket_ = 0;
};

TEST_P(PluginTest, takes_what_it_registered_and_refuses_the_rest) {
  build(section());
  ASSERT_TRUE(site_.hold(site_.id(kAio)));
  EXPECT_EQ(command(kAio, aio::kCmdState, aio::Cmd{0, 3.5f}), device::Taken::kQueued);
  ASSERT_EQ(site_.recorder.published.size(), 2u) << "open, and the voltage";
  const device::Publication& told = site_.recorder.published.back();
  EXPECT_EQ(told.device, site_.id(kAio));
  EXPECT_EQ(told.timestamp, 12.5);
  EXPECT_THAT(wire::decode<aio::Data>(told.body)->voltages, ElementsAre(3.5f));
  EXPECT_EQ(command(kOwn, op::kCmdData, bytes_of("x")), device::Taken::kNo);

  const auto answer = ask(kOwn, op::kReqData, bytes_of("abc"));
  EXPECT_TRUE(answer.ack);
  EXPECT_EQ(answer.body, wire::encode(bytes_of("abc")));
  EXPECT_FALSE(ask(kOwn, op::kReqData, bytes_of("")).ack) << "it left the reply";

  const device::Driver& driver = site_.driver(kAio);
  EXPECT_TRUE(driver.capable(site_.id(kAio), kCmd, aio::kCmdState));
  EXPECT_TRUE(driver.capable(site_.id(kOwn), kReq, op::kReqData));
  EXPECT_FALSE(driver.capable(site_.id(kOwn), kCmd, op::kCmdData));
}

TEST_P(PluginTest, reads_and_commands_the_devices_that_it_requires_until_it_has_closed) {
  build(kRelay + section(kUses));
  ASSERT_TRUE(site_.hold(site_.id(kOwn)));
  command(kOther, op::kCmdData, bytes_of("abc"));
  EXPECT_THAT(said(kOwn), ElementsAre("open", "cba"));
  site_.release(site_.id(kOwn));
  EXPECT_THAT(said(kOther), ElementsAre("abc", "stop")) << "it stops what moves";
  EXPECT_FALSE(site_.held[site_.id(kOther).row].empty()) << "until then";
  site_.hear();
  EXPECT_THAT(site_.held[site_.id(kOther).row], IsEmpty());
}

TEST_P(PluginTest, steps_in_its_period_while_it_is_open) {
  build(section(" period 0.5"));
  site_.network().run_for(10);
  EXPECT_THAT(said(kOwn), IsEmpty());
  ASSERT_TRUE(site_.hold(site_.id(kOwn)));
  site_.network().run_for(1.2);
  EXPECT_THAT(said(kOwn), ElementsAre("open", "step", "step", "step"));
  site_.release(site_.id(kOwn));
  site_.network().run_for(10);
  EXPECT_EQ(said(kOwn).size(), 4u);
}

TEST_P(PluginTest, that_throws_loses_its_devices_and_nobody_elses) {
  expect_that_it_loses_its_devices_alone("throws");
}

TEST_P(PluginTest, refuses_what_it_cannot_be) {
  EXPECT_EQ(site_.build(section("fault \"rejects\"")), R"(test.cfg:1: driver "probe": there is\x0ano port)");
  EXPECT_THAT(site_.build(section("fault \"device\"")),
              EndsWith("it registers device 7 of provides, which names 2"));
  EXPECT_THAT(site_.build(section("fault \"subtype\"")),
              EndsWith("it registers subtype 9, which no message of aio has"));
  EXPECT_THAT(site_.build(section("period 1e-9")), HasSubstr("invalid period of steps 1e-09 s"));
  const std::string isolated = GetParam() ? " isolated 1 )" : " )";
  EXPECT_THAT(site_.build(R"(driver ( name "x" plugin "stranger" provides ["aio:0"])" + isolated),
              EndsWith("is not a driver: it lacks PLAYHOUSE_DRIVER"));
  EXPECT_THAT(site_.build(R"(driver ( name "x" plugin "prob" provides ["aio:0"])" + isolated),
              EndsWith("(did you mean \"probe\"?)"));
  EXPECT_THAT(site_.build(R"(driver ( name "x" plugin "../libraries/probe" provides ["aio:0"])" + isolated),
              HasSubstr("code outside the folders of drivers; if you trust it, run with --allow-library "));
}

TEST_P(PluginTest, reads_its_section) {
  build(section(R"( period 3 length 2 unit_of "m" words ["a" "b"] sure 1 file "x.txt" angle 90)"));
  ASSERT_TRUE(site_.hold(site_.id(kOwn)));
  const auto answer = ask(kOwn, op::kReqData, bytes_of("?"));
  EXPECT_EQ(answer.body, wire::encode(bytes_of("3 2 1.57 7 -1 2 b 1 0 x.txt none")));
}

TEST_P(PluginTest, that_crashes_in_a_process_of_its_own_loses_its_devices_and_nobody_elses) {
  if (!GetParam()) return;
  expect_that_it_loses_its_devices_alone("aborts");
}

INSTANTIATE_TEST_SUITE_P(Processes, PluginTest, ::testing::Bool(),
                         [](const auto& run) { return std::string(run.param ? "isolated" : "within"); });

}  // namespace
}  // namespace playhouse::drivers
