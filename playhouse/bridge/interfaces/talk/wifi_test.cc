// Which links a radio reports: all, or those to addresses that clients watch.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "playhouse/bridge/testing/one_device.h"
#include "playhouse/wire/generated/wifi.h"

namespace playhouse::drivers {
namespace {

using ::testing::ElementsAre;
namespace wf = wire::wifi;

constexpr const char* kWorld = R"(
interval_sim 100
wifi( name "base" )
wifi( name "a" mac "08:00:20:AE:FD:7E" )
wifi( name "b" mac "08:00:20:00:00:01" )
)";
constexpr const char *kA = "08:00:20:ae:fd:7E", *kB = "08:00:20:00:00:01";

class WifiDevice : public testing::OneDevice {
 protected:
  WifiDevice() : OneDevice(kWorld) {
    open(wf::kCode, "base");
    world::World& world = still_.world();
    world.wifis.links[{0}] = {{world.id(world.find("a")), -60, 28}, {world.id(world.find("b")), -50, 60}};
  }
  bool ask_about(std::uint8_t subtype, std::string_view address) {
    return ask_with(subtype, wf::IwspyAddrReq{std::string(address)}).ack;
  }
  std::vector<std::uint32_t> qualities() {
    still_.run(1);
    std::vector<std::uint32_t> out;
    for (const wf::Link& link : last<wf::Data>(wf::kDataState).links) out.push_back(link.qual);
    return out;
  }
};

TEST_F(WifiDevice, reports_the_links_to_watched_addresses_and_all_if_there_are_none) {
  EXPECT_THAT(qualities(), ElementsAre(28, 60));
  EXPECT_TRUE(ask_about(wf::kReqIwspyAdd, kB));
  EXPECT_THAT(qualities(), ElementsAre(60));
  EXPECT_TRUE(ask_about(wf::kReqIwspyAdd, kA)) << "in any case of letters";
  EXPECT_TRUE(ask_about(wf::kReqIwspyAdd, kA)) << "again";
  EXPECT_THAT(qualities(), ElementsAre(28, 60));
  EXPECT_TRUE(ask_about(wf::kReqIwspyDel, kB));
  EXPECT_THAT(qualities(), ElementsAre(28));
  EXPECT_TRUE(ask_about(wf::kReqIwspyDel, kA));
  EXPECT_FALSE(ask_about(wf::kReqIwspyDel, kA)) << "not watched any more";
  EXPECT_THAT(qualities(), ElementsAre(28, 60));
}

TEST_F(WifiDevice, a_ping_tells_whether_a_radio_is_received) {
  EXPECT_TRUE(ask_about(wf::kReqIwspyPing, kA));
  still_.world().wifis.links[{0}].clear();
  EXPECT_FALSE(ask_about(wf::kReqIwspyPing, kA));
}

TEST_F(WifiDevice, watches_eight_addresses_until_it_is_closed) {
  EXPECT_FALSE(ask_about(wf::kReqIwspyAdd, ""));
  EXPECT_FALSE(ask_about(wf::kReqIwspyAdd, "08:00:20:00:00:0g"));
  EXPECT_FALSE(ask_about(wf::kReqIwspyAdd, "08-00-20-00-00-01"));
  EXPECT_FALSE(ask_about(wf::kReqIwspyAdd, "192.168.0.9"));
  for (char last = '1'; last <= '8'; ++last)
    EXPECT_TRUE(ask_about(wf::kReqIwspyAdd, std::string("00:00:00:00:00:0") + last));
  EXPECT_FALSE(ask_about(wf::kReqIwspyAdd, kA));
  EXPECT_THAT(qualities(), ElementsAre());
  reopen();
  EXPECT_THAT(qualities(), ElementsAre(28, 60));
}

}  // namespace
}  // namespace playhouse::drivers
