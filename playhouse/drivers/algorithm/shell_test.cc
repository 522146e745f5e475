// An algorithm in its shell, between a device that it uses and a client.

#include "playhouse/drivers/algorithm/shell.h"
#include "playhouse/bridge/simulated/simulated_world.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "playhouse/bridge/testing/memory_site.h"
#include "playhouse/drivers/refusal.h"
#include "playhouse/wire/generated/common.h"
#include "playhouse/wire/generated/laser.h"
#include "playhouse/wire/generated/position2d.h"

namespace playhouse::drivers {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using testing::MemorySite;
namespace p2d = wire::position2d;

constexpr device::Address kWheels{6665, 4, 0}, kOwn{6665, 4, 1}, kSecond{6665, 4, 2};
constexpr std::uint8_t kCmd = 2, kReq = 3;

constexpr const char* kWorld = R"(
interval_sim 100
position( name "r0" size [0.4 0.4 0.2] )
)";
constexpr const char* kSections = R"(
driver( name "stage" provides ["simulation:0"] worldfile "some.world" )
driver( name "stage" provides ["position2d:0"] model "r0" )
driver( name "mirror" provides ["position2d:1" "one:::position2d:2"] requires ["position2d:0"] factor 2 ))";

struct MirrorOptions {
  double factor = 1;
};

Result<MirrorOptions> mirror_options(const config::CfgSection& section) {
  return MirrorOptions{section.number("factor", 1)};
}

/// Drives as it is told, times a factor, one tick later.
class Mirror final : public Algorithm {
 public:
  Mirror(Shell& shell, const MirrorOptions& options, std::vector<std::string>& calls)
      : shell_(shell), calls_(calls), states_(shell.client().latest(0, p2d::kDataState)) {
    shell.on_command<p2d::CmdVel>(p2d::kCmdVel, [this, options](const p2d::CmdVel& command) {
      shell_.post([this, speed = options.factor * command.vel.px](bool) -> AlgorithmThread::Delivery {
        return [this, speed] {
          shell_.client().command(0, p2d::kCmdVel, wire::encode(p2d::CmdVel{{speed, 0, 0}, 1}));
        };
      });
      return device::Taken::kLatest;
    });
    shell.forward_request(p2d::kReqGetGeom, 0);
    shell.on_request<p2d::SetOdomReq>(p2d::kReqSetOdom, [](const p2d::SetOdomReq& asked) -> AnswerBody {
      if (asked.pose.px < 0) return std::nullopt;
      return wire::encode(p2d::SetOdomReq{{asked.pose.px + 1, 0, 0}});
    });
    shell.on_refusal_asked([] { return std::string("too far"); });
  }
  void opened() override { calls_.push_back("opened"); }
  void closing() override { calls_.push_back(shell_.client().is_open() ? "closing" : "closed too early"); }
  void closed() override { calls_.push_back("closed"); }
  void take_news(std::vector<device::Publication>& more) override {
    const std::optional<device::Publication> state = states_.take_latest();
    if (state) more.push_back({shell_.device(1), p2d::kDataState, state->timestamp, state->body});
  }
  void rewound(const Moment& moment) override { calls_.push_back("rewound " + std::to_string(moment.tick)); }

 private:
  Shell& shell_;
  std::vector<std::string>& calls_;
  device::Subscription& states_;
};

class ShellTest : public ::testing::Test {
 protected:
  ShellTest() : site(kWorld) {
    config::MemoryFiles none({});
    const config::CfgFile file = *config::load_cfg_text(kSections, "test.cfg", none);
    const config::CfgSection& mirror = file.drivers.back();
    const WantedDevices wanted{.provides = {{"position2d"}, {"position2d", "one"}}, .uses = {{"position2d"}}};
    Result<std::unique_ptr<device::Driver>> made =
        make_algorithm<Mirror>(mirror, site.site(), wanted, mirror_options, std::ref(calls));
    EXPECT_TRUE(made) << made.error().line();
    driver = std::move(*made);
    EXPECT_EQ(site.build(R"(
driver( name "stage" provides ["simulation:0"] worldfile "some.world" )
driver( name "stage" provides ["position2d:0"] model "r0" ))"),
              "");
    simulation_of(site.site())->engine().world().positions.motor_on[{0}] = 1;
  }
  testing::OutputRecorder::RecordedAnswer ask(device::Address address, std::uint8_t subtype,
                                              const std::vector<std::byte>& body) {
    driver->request({site.id(address), kReq, subtype, body}, device::Replier(site.recorder, 1));
    site.run(0);
    return site.recorder.answers.at(1);
  }
  device::Taken drive(device::Address address, double speed) {
    return driver->command(
        {site.id(address), kCmd, p2d::kCmdVel, wire::encode(p2d::CmdVel{{speed, 0, 0}, 1})});
  }

  std::vector<std::string> calls;
  std::unique_ptr<device::Driver> driver;  // the site refers to it until it ends
  MemorySite site;
};

TEST_F(ShellTest, uses_its_devices_while_one_of_its_own_is_open) {
  const auto held = [this] { return site.held[site.id(kWheels).row].size(); };
  EXPECT_EQ(drive(kOwn, 1), device::Taken::kNo) << "a command must not wait for the next client";
  ASSERT_TRUE(site.hold(site.id(kOwn)));
  ASSERT_TRUE(site.hold(site.id(kSecond)));
  site.release(site.id(kOwn));
  EXPECT_EQ(held(), 1u);
  EXPECT_THAT(calls, ElementsAre("opened"));
  site.release(site.id(kSecond));
  EXPECT_EQ(held(), 0u);
  EXPECT_THAT(calls, ElementsAre("opened", "closing", "closed"));
}

TEST_F(ShellTest, closes_once_when_a_device_that_it_uses_retires) {
  ASSERT_TRUE(site.hold(site.id(kOwn)));
  site.retire_device(site.id(kWheels));
  site.release(site.id(kOwn));
  EXPECT_THAT(calls, ElementsAre("opened", "closing", "closed"));
}

TEST_F(ShellTest, what_a_step_says_comes_one_tick_later) {
  ASSERT_TRUE(site.hold(site.id(kOwn)));
  const world::World& world = simulation_of(site.site())->world();
  EXPECT_EQ(drive(kOwn, 0.25), device::Taken::kLatest);
  site.run(1);
  EXPECT_EQ(world.positions.command[{0}].x, 0);
  site.run(2);
  EXPECT_EQ(world.positions.command[{0}].x, 0.5);
}

TEST_F(ShellTest, takes_and_answers_what_its_algorithm_registered) {
  ASSERT_TRUE(site.hold(site.id(kOwn)));
  EXPECT_EQ(drive(kSecond, 1), device::Taken::kNo) << "the other device takes none";
  EXPECT_EQ(driver->command({site.id(kOwn), kCmd, p2d::kCmdVel, {}}), device::Taken::kNo) << "no body";
  EXPECT_DOUBLE_EQ(wire::decode<p2d::Geom>(ask(kOwn, p2d::kReqGetGeom, {}).body)->size.sl, 0.4);
  EXPECT_FALSE(ask(kSecond, p2d::kReqGetGeom, {}).ack);
  const testing::OutputRecorder::RecordedAnswer odom =
      ask(kOwn, p2d::kReqSetOdom, wire::encode(p2d::SetOdomReq{{2, 0, 0}}));
  EXPECT_EQ(wire::decode<p2d::SetOdomReq>(odom.body)->pose.px, 3);
  EXPECT_FALSE(ask(kOwn, p2d::kReqSetOdom, wire::encode(p2d::SetOdomReq{{-2, 0, 0}})).ack);
  EXPECT_FALSE(ask(kOwn, p2d::kReqSetOdom, {}).ack);
  EXPECT_FALSE(ask(kOwn, p2d::kReqResetOdom, {}).ack);
  const std::vector<std::byte> refusal =
      wire::encode(wire::StrpropReq{wire::c_string("refusal"), wire::c_string("")});
  const Result<wire::StrpropReq> why =
      wire::decode<wire::StrpropReq>(ask(kOwn, wire::kReqGetStrprop, refusal).body);
  EXPECT_EQ(wire::text(why->value), "too far");
  const auto is_capable = [this](device::Address address, std::uint8_t type, std::uint8_t subtype) {
    return driver->capable(site.id(address), type, subtype);
  };
  EXPECT_TRUE(is_capable(kOwn, kCmd, p2d::kCmdVel));
  EXPECT_FALSE(is_capable(kSecond, kCmd, p2d::kCmdVel));
  EXPECT_TRUE(is_capable(kOwn, kReq, p2d::kReqGetGeom));
  EXPECT_TRUE(is_capable(kOwn, kReq, p2d::kReqSetOdom));
  EXPECT_FALSE(is_capable(kOwn, kReq, p2d::kReqResetOdom));
}

TEST_F(ShellTest, publishes_in_the_batch_of_what_it_read_and_belongs_to_its_robot) {
  ASSERT_TRUE(site.hold(site.id(kOwn)));
  site.run(1);
  EXPECT_EQ(site.recorder.batches, 1);
  EXPECT_EQ(site.recorder.published.back().device, site.id(kSecond));
  Directory& directory = model_devices_of(site.site())->directory();
  EXPECT_EQ(directory.model_of(kSecond), directory.model_of(kWheels));
}

TEST_F(ShellTest, a_rewind_drops_steps) {
  ASSERT_TRUE(site.hold(site.id(kOwn)));
  drive(kOwn, 0.25);
  static_cast<Shell&>(*driver).rewound({7, 0.7, 1});
  site.run(3);
  EXPECT_EQ(simulation_of(site.site())->world().positions.command[{0}].x, 0);
  EXPECT_THAT(calls, ElementsAre("opened", "rewound 7"));
}

}  // namespace
}  // namespace playhouse::drivers
