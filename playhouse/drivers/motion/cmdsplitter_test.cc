#include "playhouse/drivers/motion/cmdsplitter.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "playhouse/drivers/testing/driver_bench.h"
#include "playhouse/wire/generated/position2d.h"

namespace playhouse::drivers {
namespace {

using ::testing::HasSubstr;
namespace p2d = wire::position2d;

constexpr device::Address kFirst{6665, p2d::kCode, 0}, kSecond{6665, p2d::kCode, 1},
    kThird{6665, p2d::kCode, 2}, kAll{6665, p2d::kCode, 3};

struct SplitBench : testing::DriverBench {
  explicit SplitBench(const std::string& options)
      : DriverBench(
            "driver( name \"cmdsplitter\" provides [\"position2d:3\"] requires [\"1:::position2d:1\" "
            "\"0:::position2d:0\" \"2:::position2d:2\"] devices 3 " +
                options + " )",
            {kFirst, kSecond, kThird}, kAll) {
    answers(kFirst, p2d::kReqMotorPower, p2d::PowerConfig{1});
  }
};

TEST(CmdSplitter, tells_all_and_has_the_data_of_the_first) {
  SplitBench bench("");
  EXPECT_EQ(bench.command(p2d::kCmdVel, p2d::CmdVel{{0.3, 0, 0}, 1}), device::Taken::kLatest);
  EXPECT_EQ(bench.told().commands.size(), 3u);
  EXPECT_EQ(bench.commanded<p2d::CmdVel>(kThird, p2d::kCmdVel).at(0).vel.px, 0.3);
  bench.says(kSecond, p2d::kDataState, 1, p2d::Data{{9, 9, 9}, {}, 0});
  bench.says(kFirst, p2d::kDataState, 1, p2d::Data{{1, 2, 3}, {}, 0});
  const auto states = bench.heard<p2d::Data>(p2d::kDataState);
  ASSERT_EQ(states.size(), 1u);
  EXPECT_EQ(states[0].pos.px, 1);
}

TEST(CmdSplitter, asks_all_and_answers_with_what_the_first_says) {
  SplitBench bench("");
  EXPECT_TRUE(bench.ask(p2d::kReqMotorPower, wire::encode(p2d::PowerConfig{1})))
      << "though the others refuse it";
  EXPECT_EQ(bench.told().requests.size(), 3u);
}

TEST(CmdSplitter, asks_the_first_alone_if_it_is_to) {
  SplitBench bench("rq_first_device_only 1");
  EXPECT_TRUE(bench.ask(p2d::kReqMotorPower, wire::encode(p2d::PowerConfig{1})));
  EXPECT_EQ(bench.told().requests.size(), 1u);
}

TEST(CmdSplitter, is_no_way_round_the_rights_to_manage_a_run) {
  EXPECT_EQ(testing::fault_of(
                "driver( name \"cmdsplitter\" provides [\"simulation:1\"] requires [\"0:::simulation:0\"] )"),
            "test.cfg:1: driver \"cmdsplitter\" is not for devices of simulation");
}

TEST(CmdSplitter, needs_devices_with_numbers_and_of_one_interface) {
  EXPECT_THAT(testing::fault_of(
                  "driver( name \"cmdsplitter\" provides [\"position2d:3\"] requires [\"position2d:0\"] )"),
              HasSubstr("test.cfg:1: driver \"cmdsplitter\" requires one position2d of key 0"));
  EXPECT_THAT(testing::fault_of(
                  "driver( name \"cmdsplitter\" provides [\"position2d:3\"] requires [\"0:::laser:0\"] )"),
              HasSubstr("test.cfg:1: driver \"cmdsplitter\" requires one position2d of key 0"));
}

}  // namespace
}  // namespace playhouse::drivers
