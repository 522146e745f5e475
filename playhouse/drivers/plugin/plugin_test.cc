// Drivers of shared libraries, by way of a configuration file: testing/libraries/probe.cc.

#include "playhouse/drivers/plugin/plugin.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <spdlog/logger.h>
#include <spdlog/sinks/ostream_sink.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include "playhouse/base/limits.h"
#include "playhouse/base/testing_folder.h"
#include "playhouse/bridge/testing/memory_site.h"
#include "playhouse/wire/codec.h"
#include "playhouse/wire/generated/aio.h"
#include "playhouse/wire/generated/common.h"
#include "playhouse/wire/generated/opaque.h"
#include "playhouse/wire/header.h"
#include "playhouse/wire/messages.h"

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

/// What the log says during `act`.
template <typename Act>
std::string logged(const Act& act) {
  std::ostringstream text;
  const auto before = spdlog::default_logger();
  spdlog::set_default_logger(
      std::make_shared<spdlog::logger>("test", std::make_shared<spdlog::sinks::ostream_sink_mt>(text)));
  act();
  spdlog::set_default_logger(before);
  return text.str();
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
  /// As a client does; "" or why not.
  std::string open(device::Address address) {
    const auto why = std::make_shared<std::string>("it is not told");
    site_.driver(address).prepare(site_.id(address), [why](const Result<void>& outcome) {
      *why = outcome ? "" : outcome.error().line();
    });
    for (int drivers = 0; drivers < 2; ++drivers) site_.hear();  // what it uses, and itself
    if (!why->empty()) return *why;
    const Result<void> held = site_.hold(site_.id(address));
    return held ? "" : held.error().line();
  }
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
    ASSERT_EQ(open(kAio), "");
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
  ASSERT_EQ(open(kAio), "");
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
  ASSERT_EQ(open(kOwn), "");
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
  ASSERT_EQ(open(kOwn), "");
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
  TestFolder elsewhere;
  std::filesystem::copy(TEST_LIBRARIES "/probe.so", elsewhere / "probe.so");
  EXPECT_THAT(site_.build("driver ( name \"x\" plugin \"" + (elsewhere / "probe") +
                          "\" provides [\"aio:0\"]" + isolated),
              HasSubstr("code outside the folders of drivers; if you trust it, run with --allow-library "));
}

TEST_P(PluginTest, comes_from_what_the_file_names_outside_its_sections) {
  const auto built = [](const std::string& plugins, const std::string& name) {
    MemorySite site("", false);
    const std::string why =
        site.build(plugins + "driver ( name \"" + name + "\" provides [\"aio:0\" \"opaque:0\"]" +
                   (GetParam() ? " isolated 1 )" : " )"));
    std::string told = why;
    for (const std::string& line : site.site().warnings()) told += line;
    return told;
  };
  EXPECT_EQ(built("plugin \"probe\"\n", "probe"), "");
  EXPECT_EQ(built("plugin \"probe.so\"\n", "libprobe"), "");
  EXPECT_EQ(built("plugin \"probe\"\n", "other"), "") << "it is the only one";
  EXPECT_EQ(built("plugin \"stranger\"\nplugin \"probe\"\n", "probe"),
            R"(test.cfg:1: "plugin" has no effect: no driver of this file needs "stranger")");
  EXPECT_EQ(built("plugin \"stageplugin\"\n", "other"),
            R"(test.cfg:2: driver "other": this program has no such driver, and the plug-in of this file, )"
            R"("stageplugin", is not found)");
  EXPECT_EQ(built("plugin \"probe\"\nplugin \"stranger\"\n", "other"),
            R"(test.cfg:3: driver "other": this program has no such driver, and no plug-in of this file has )"
            R"(its name: "probe", "stranger")");
  EXPECT_THAT(built("plugin \"libprobe\"\n", "probe"), HasSubstr("no driver \"libprobe\""));
}

TEST_P(PluginTest, that_fails_to_open_lives_on_and_may_be_tried_again) {
  build(kRelay + section(kUses + " fault \"fails to open\" period 0.5"));
  const device::Driver& driver = site_.driver(kOwn);
  EXPECT_FALSE(driver.ready(site_.id(kOwn)));
  EXPECT_EQ(open(kOwn), R"(there is\x0ano port)");
  EXPECT_THAT(site_.held[site_.id(kOther).row], IsEmpty());
  EXPECT_FALSE(ask(kOwn, op::kReqData, bytes_of("abc")).ack) << "it is not open";
  EXPECT_THAT(said(kOwn), IsEmpty()) << "nor was it closed";
  EXPECT_EQ(open(kOwn), "");
  EXPECT_TRUE(driver.ready(site_.id(kAio)));
  EXPECT_THAT(site_.retired, IsEmpty());
  EXPECT_THAT(said(kOwn), ElementsAre("open", "step"));
  site_.release(site_.id(kOwn));
  EXPECT_FALSE(driver.ready(site_.id(kOwn)));
  EXPECT_THAT(said(kOwn), ElementsAre("open", "step", "close", "pots")) << "what the relay was told";
}

TEST_P(PluginTest, that_was_opened_for_somebody_who_went_is_closed_again) {
  build(kRelay + section(kUses));
  site_.driver(kOwn).prepare(site_.id(kOwn), [](const Result<void>&) {});
  site_.hear();
  EXPECT_FALSE(site_.held[site_.id(kOther).row].empty());
  site_.network().run_for(2 * limits::kPluginSeconds);
  EXPECT_THAT(said(kOther), ElementsAre("stop"));
  site_.hear();
  EXPECT_THAT(site_.held[site_.id(kOther).row], IsEmpty());
}

TEST_P(PluginTest, with_alwayson_is_tried_until_it_opens) {
  build(section("fault \"fails to open\" alwayson 1"));
  site_.hear();
  EXPECT_THAT(site_.held[site_.id(kOwn).row], IsEmpty());
  for (int tries = 0; tries < 4 && site_.held[site_.id(kOwn).row].empty(); ++tries) {
    site_.network().run_for(60);
    site_.hear();
  }
  EXPECT_EQ(site_.held[site_.id(kOwn).row].size(), 1u);
  EXPECT_EQ(site_.held[site_.id(kAio).row].size(), 1u);
}

/// Two probes: the second is what the first uses.
constexpr const char* kSecond = R"(driver ( name "probe" plugin "probe" provides ["aio:1" "opaque:1"] )
)";

TEST_P(PluginTest, asks_with_a_body_for_a_value_or_an_acknowledgement) {
  build(kSecond + section(kUses));
  ASSERT_EQ(open(kOwn), "");
  EXPECT_EQ(ask(kOwn, op::kReqData, bytes_of("value of abc")).body, wire::encode(bytes_of("abc")));
  EXPECT_EQ(ask(kOwn, op::kReqData, bytes_of("value of ")).body, wire::encode(bytes_of("none"))) << "NACK";
  EXPECT_EQ(ask(kOwn, op::kReqData, bytes_of("ack of abc")).body, wire::encode(bytes_of("yes")));
  EXPECT_EQ(ask(kOwn, op::kReqData, bytes_of("ack of ")).body, wire::encode(bytes_of("no")));
  EXPECT_EQ(ask(kOwn, op::kReqData, bytes_of("nobody")).body, wire::encode(bytes_of("no")));
}

TEST_P(PluginTest, passes_requests_on_that_it_has_not_registered) {
  build(kSecond + section(kUses + " passes 1"));
  ASSERT_EQ(open(kOwn), "");
  const auto answer = ask(kOwn, op::kReqData, bytes_of("abc"));
  EXPECT_TRUE(answer.ack);
  EXPECT_EQ(answer.body, wire::encode(bytes_of("abc")));
  EXPECT_FALSE(ask(kOwn, op::kReqData, bytes_of("")).ack);
  const device::Driver& driver = site_.driver(kOwn);
  EXPECT_TRUE(driver.capable(site_.id(kOwn), kReq, op::kReqData));
  EXPECT_FALSE(driver.capable(site_.id(kOwn), kReq, wire::kReqGetIntprop)) << "the other has no properties";
}

TEST_P(PluginTest, passes_requests_on_to_a_device_of_the_same_interface_alone) {
  EXPECT_THAT(site_.build(section("passes 1")),
              EndsWith("requests of a device are passed on which the section does not name"));
  EXPECT_THAT(site_.build("driver ( name \"probe\" plugin \"probe\" provides [\"aio:7\" \"opaque:7\"] )\n" +
                          section(" passes 1 requires [\"aio:7\"]")),
              EndsWith("requests to opaque are not those to aio"));
}

TEST_P(PluginTest, that_says_what_is_no_message_is_told_so_once) {
  build(kRelay + section(kUses + " fault \"says nonsense\""));
  ASSERT_EQ(open(kAio), "");
  const std::string log = logged([&] {
    for (int times = 0; times < 3; ++times)
      EXPECT_EQ(command(kAio, aio::kCmdState, aio::Cmd{0, 3.5f}), device::Taken::kQueued) << "it lives";
  });
  for (const std::string line :
       {"data is left out: there is no device 99 in a list of 2",
        "data is left out: no message of opaque has subtype 77", "data is left out: it has no time",
        "a command is left out: there is no device 99 in a list of 1",
        "a request gets NACK: there is no device 99 in a list of 1"})
    EXPECT_THAT(log, HasSubstr("driver \"probe\": " + line));
  EXPECT_EQ(std::ranges::count(log, '\n'), 5) << log;
  EXPECT_THAT(said(kOwn), ElementsAre("open"));
}

TEST_P(PluginTest, reads_its_section) {
  build(section(R"( period 3 length 2 unit_of "m" words ["a" "b"] sure 1 file "x.txt" angle 90)"));
  ASSERT_EQ(open(kOwn), "");
  const auto answer = ask(kOwn, op::kReqData, bytes_of("?"));
  EXPECT_EQ(answer.body, wire::encode(bytes_of("3 2 1.57 7 -1 2 b 1 0 x.txt none")));
}

/// As IsolatedPlugin.that_sends_frames_without_sense_is_ended, by way of the shell.
TEST_P(PluginTest, that_sends_frames_without_sense_publishes_no_invalid_message) {
  if (!GetParam()) return;
  std::size_t published = 0;
  for (int seed = 0; seed < 30; ++seed) {
    MemorySite site("", false);
    ASSERT_EQ(site.build(section("fault \"rambles " + std::to_string(seed) + "\"")), "");
    device::Driver& driver = site.driver(kAio);
    driver.prepare(site.id(kAio), [](const Result<void>&) {});
    site.hear();
    ASSERT_TRUE(site.hold(site.id(kAio)));
    driver.command({site.id(kAio), kCmd, aio::kCmdState, wire::encode(aio::Cmd{0, 3.5f})});
    driver.finish();
    for (const device::Publication& each : site.recorder.published) {
      const std::uint16_t interf = each.device == site.id(kAio) ? aio::kCode : op::kCode;
      const wire::MessageDef* const message =
          wire::find_message(interf, wire::MessageType::kData, each.subtype);
      ASSERT_NE(message, nullptr);
      EXPECT_EQ(message->check(each.body), "");
      ++published;
    }
  }
  EXPECT_GE(published, 30u) << "that it is open";
}

TEST_P(PluginTest, that_crashes_in_a_process_of_its_own_loses_its_devices_and_nobody_elses) {
  if (!GetParam()) return;
  expect_that_it_loses_its_devices_alone("aborts");
}

INSTANTIATE_TEST_SUITE_P(Processes, PluginTest, ::testing::Bool(),
                         [](const auto& run) { return std::string(run.param ? "isolated" : "within"); });

}  // namespace
}  // namespace playhouse::drivers
