// The driver "amcl" on a simulated robot that stands still, with its odometry moved by hand.

#include "playhouse/drivers/amcl/amcl.h"
#include "playhouse/bridge/simulated/simulated_world.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "playhouse/bridge/testing/memory_site.h"
#include "playhouse/drivers/testing/two_eyes.h"
#include "playhouse/wire/codec.h"
#include "playhouse/wire/generated/position2d.h"
#include "playhouse/world/population/population.h"

namespace playhouse::drivers {
namespace {

using ::testing::HasSubstr;
using testing::MemorySite;
namespace lcl = wire::localize;
namespace p2d = wire::position2d;

constexpr device::Address kWheels{6665, p2d::kCode, 0}, kCorrected{6665, p2d::kCode, 2},
    kLocalize{6665, lcl::kCode, 0};
constexpr std::uint8_t kReq = 3;

constexpr const char* kWorld = R"(
interval_sim 100
model( name "walls" size [10 1 1] pose [0 3 0 0] )
position( name "r0" size [0.4 0.4 0.2] pose [1 0 0 0] localization "odom" odom_error [0 0 0 0]
  ranger( sensor( range [0 8] fov 180 samples 181 ) ) )
)";

// From the last in the chain to the first.
std::string chain(const std::string& options, const std::string& provides = "\"localize:0\" \"position2d:2\"",
                  const std::string& required = "\"odometry:::position2d:0\" \"laser:0\" \"laser:::map:0\"") {
  return "driver( name \"amcl\" provides [" + provides + "] requires [" + required + "] " + options +
         R"( )
driver( name "rangertolaser" provides ["laser:0"] requires ["ranger:0"] )
driver( name "stage" provides ["simulation:0"] worldfile "some.world" )
driver( name "stage" provides ["map:0"] model "walls" )
driver( name "stage" provides ["position2d:0" "ranger:0"] model "r0" ))";
}

std::string fault(const std::string& cfg) {
  return MemorySite(kWorld).build(cfg);
}

class AmclTest : public ::testing::Test {
 protected:
  explicit AmclTest(bool has_threads = true) : site(kWorld, has_threads) {
    EXPECT_EQ(site.build(chain("init_pose [1 0 90] init_pose_var [0.1 0.1 5]")), "");
    // What a robot at (1, 0) that looks along y sees of the wall, and nothing beyond it.
    for (std::uint32_t i = 0; i <= 180; ++i) {
      const double range = 2.5 / std::max(1e-9, std::sin(geom::radians(i)));
      world().sensors.ranges[{i}] = static_cast<float>(std::min(range, 8.0));
    }
    EXPECT_TRUE(site.hold(site.id(kLocalize)));
    EXPECT_TRUE(site.hold(site.id(kCorrected)));
  }
  world::World& world() { return simulation_of(site.site())->engine().world(); }
  device::Driver& driver() { return site.driver(kLocalize); }
  /// The odometry says that the robot is there now.
  void move(const geom::Pose& X_OR) { world().positions.X_OM[{0}] = X_OR; }
  template <typename T>
  T newest(device::Address address) {
    const auto found =
        std::find_if(site.recorder.published.rbegin(), site.recorder.published.rend(),
                     [&](const device::Publication& each) { return each.device == site.id(address); });
    EXPECT_NE(found, site.recorder.published.rend());
    return *wire::decode<T>(found->body);
  }
  testing::OutputRecorder::RecordedAnswer ask(device::Address address, std::uint8_t subtype,
                                              const std::vector<std::byte>& body) {
    driver().request({site.id(address), kReq, subtype, body}, device::Replier(site.recorder, 1));
    site.run(0);
    return site.recorder.answers.at(1);
  }

  MemorySite site;
};

TEST_F(AmclTest, corrects_the_odometry_to_the_map) {
  site.run(1);
  EXPECT_EQ(newest<p2d::Data>(kCorrected).pos, (wire::Pose2d{1, 0, geom::radians(90)})) << "as configured";
  EXPECT_EQ(newest<lcl::Data>(kLocalize).hypoths.size(), 1u);
  EXPECT_DOUBLE_EQ(newest<lcl::Data>(kLocalize).hypoths[0].cov[0], 0.01);
  site.run(2);
  const lcl::Data found = newest<lcl::Data>(kLocalize);
  ASSERT_GE(found.hypoths.size(), 1u);
  EXPECT_NEAR(found.hypoths[0].mean.py, 0, 0.05) << "the wall tells the distance";
  EXPECT_NEAR(found.hypoths[0].mean.pa, geom::radians(90), geom::radians(3));
  EXPECT_LT(found.hypoths[0].cov[1], 0.005);
  EXPECT_DOUBLE_EQ(found.pending_time, 0.1);
  EXPECT_EQ(newest<p2d::Data>(kCorrected).pos, found.hypoths[0].mean);
}

TEST_F(AmclTest, adds_motions_that_are_too_small_for_a_step) {
  site.run(3);
  const wire::Pose2d before = newest<p2d::Data>(kCorrected).pos;
  move({0.15, 0, 0, 0});
  site.run(1);
  const p2d::Data after = newest<p2d::Data>(kCorrected);
  EXPECT_NEAR(std::hypot(after.pos.px - before.px, after.pos.py - before.py), 0.15, 1e-9);
  EXPECT_DOUBLE_EQ(newest<lcl::Data>(kLocalize).pending_time, 0.1) << "no step";
  EXPECT_EQ(newest<lcl::Data>(kLocalize).hypoths[0].mean, after.pos);
  move({0.2, 0, 0, 0});
  site.run(3);
  EXPECT_DOUBLE_EQ(newest<lcl::Data>(kLocalize).pending_time, 0.5);
}

TEST_F(AmclTest, begins_anew_with_the_pose_that_a_client_sets) {
  site.run(3);
  const lcl::SetPose pose{{0, 0.2, geom::radians(90)}, {0.01, 0.04, 0.01, 0, 0, 0}};
  EXPECT_TRUE(ask(kLocalize, lcl::kReqSetPose, wire::encode(pose)).ack);
  site.run(1);
  EXPECT_EQ(newest<p2d::Data>(kCorrected).pos, pose.mean);
  site.run(2);
  EXPECT_LT(newest<p2d::Data>(kCorrected).pos.px, 0.5);
  EXPECT_NEAR(newest<p2d::Data>(kCorrected).pos.py, 0, 0.1) << "so far from the wall";
  EXPECT_FALSE(ask(kLocalize, lcl::kReqSetPose, wire::encode(lcl::SetPose{{}, {-1, 0, 0, 0, 0, 0}})).ack);
}

TEST_F(AmclTest, goes_on_after_a_rewind_with_what_it_believed_then) {
  site.run(3);
  const wire::Pose2d then = newest<p2d::Data>(kCorrected).pos;
  move({0.3, 0.3, 0, 0});
  site.run(3);
  EXPECT_DOUBLE_EQ(newest<lcl::Data>(kLocalize).pending_time, 0.4);
  static_cast<Shell&>(driver()).rewound({4, 0.35, 1});
  move({0, 0, 0, 0});
  site.run(1);
  EXPECT_EQ(newest<p2d::Data>(kCorrected).pos, then);
  static_cast<Shell&>(driver()).rewound({0, 0, 1});
  site.run(1);
  EXPECT_EQ(newest<p2d::Data>(kCorrected).pos, (wire::Pose2d{1, 0, geom::radians(90)})) << "as configured";
}

TEST_F(AmclTest, odometry_that_is_set_is_no_motion) {
  move({0.1, 0, 0, 0});
  site.run(3);
  const wire::Pose2d before = newest<p2d::Data>(kCorrected).pos;
  move({-3, 5, 0, 2});
  site.run(1);
  EXPECT_NEAR(newest<p2d::Data>(kCorrected).pos.px, before.px, 1e-9);
  EXPECT_NEAR(newest<p2d::Data>(kCorrected).pos.py, before.py, 1e-9);
  EXPECT_NEAR(newest<p2d::Data>(kCorrected).pos.pa, before.pa, 1e-9);
  move(geom::compose(geom::Pose{-3, 5, 0, 2}, geom::Pose{0.3, 0, 0, 0}));
  site.run(1);
  EXPECT_NEAR(newest<p2d::Data>(kCorrected).pos.py, before.py + 0.3 * geom::sincos(before.pa).sin, 1e-9);
}

TEST_F(AmclTest, answers_with_its_particles) {
  const auto first = wire::decode<lcl::GetParticles>(ask(kLocalize, lcl::kReqGetParticles, {}).body);
  ASSERT_TRUE(first);
  EXPECT_TRUE(first->particles.empty());
  EXPECT_EQ(first->mean, (wire::Pose2d{1, 0, geom::radians(90)})) << "as configured";
  EXPECT_DOUBLE_EQ(first->variance, 0.02);
  site.run(3);
  const auto answer = wire::decode<lcl::GetParticles>(ask(kLocalize, lcl::kReqGetParticles, {}).body);
  ASSERT_TRUE(answer);
  ASSERT_GE(answer->particles.size(), 100u);
  EXPECT_EQ(answer->mean, newest<lcl::Data>(kLocalize).hypoths[0].mean);
  double x = 0, weights = 0;
  for (const lcl::Particle& particle : answer->particles) {
    x += particle.pose.px * particle.alpha;
    weights += particle.alpha;
  }
  EXPECT_NEAR(weights, 1, 1e-9);
  EXPECT_NEAR(x, answer->mean.px, 0.05);
}

TEST_F(AmclTest, its_position_is_of_the_size_of_the_robot_and_takes_no_commands) {
  const auto geometry = wire::decode<p2d::Geom>(ask(kCorrected, p2d::kReqGetGeom, {}).body);
  ASSERT_TRUE(geometry);
  EXPECT_DOUBLE_EQ(geometry->size.sl, 0.4);
  EXPECT_FALSE(ask(kCorrected, p2d::kReqResetOdom, {}).ack);
  EXPECT_EQ(driver().command({site.id(kCorrected), 2, p2d::kCmdVel, wire::encode(p2d::CmdVel{})}),
            device::Taken::kNo);
  EXPECT_TRUE(driver().capable(site.id(kLocalize), kReq, lcl::kReqSetPose));
  EXPECT_FALSE(driver().capable(site.id(kCorrected), kReq, lcl::kReqGetParticles));
}

TEST_F(AmclTest, has_its_devices_open_while_one_of_its_own_is) {
  const auto holders = [&] { return site.held[site.id(kWheels).row].size(); };
  EXPECT_EQ(holders(), 1u);
  site.release(site.id(kLocalize));
  EXPECT_EQ(holders(), 1u);
  site.release(site.id(kCorrected));
  EXPECT_EQ(holders(), 0u);
}

TEST_F(AmclTest, retires_with_its_robot) {
  run::Simulation& simulation = *simulation_of(site.site());
  const world::ModelId robot = simulation.world().id(simulation.world().find("r0"));
  EXPECT_EQ(model_devices_of(site.site())->directory().model_of(kLocalize), robot);
  site.run(1);
  ASSERT_TRUE(
      simulation.requests().post([&](world::Journal& journal) { EXPECT_TRUE(journal.despawn(robot)); }));
  site.run(3);
  site.run(0);
  EXPECT_FALSE(site.site().find(kLocalize).has_value());
  EXPECT_FALSE(site.site().find(kCorrected).has_value());
}

class AmclWithoutThreads : public AmclTest {
 protected:
  AmclWithoutThreads() : AmclTest(false) {}
};

TEST_F(AmclWithoutThreads, believes_the_same_at_the_same_ticks) {
  MemorySite threaded(kWorld);
  ASSERT_EQ(threaded.build(chain("init_pose [1 0 90] init_pose_var [0.1 0.1 5]")), "");
  ASSERT_TRUE(threaded.hold(threaded.id(kLocalize)));
  world::World& other = simulation_of(threaded.site())->engine().world();
  std::ranges::copy(world().sensors.ranges, other.sensors.ranges.begin());
  for (int step = 0; step < 8; ++step) {
    other.positions.X_OM[{0}] = {0.15 * step, 0, 0, 0};
    move({0.15 * step, 0, 0, 0});
    threaded.run(1);
    site.run(1);
  }
  const auto published = [](MemorySite& of) {
    std::vector<std::vector<std::byte>> bodies;
    for (device::Publication& each : of.recorder.published)
      if (each.device == of.id(kLocalize)) bodies.push_back(std::move(each.body));
    return bodies;
  };
  const std::vector<std::vector<std::byte>> bodies = published(site);
  EXPECT_EQ(bodies.size(), 8u);
  EXPECT_DOUBLE_EQ(wire::decode<lcl::Data>(bodies.back())->pending_time, 0.5) << "it took steps";
  EXPECT_EQ(bodies, published(threaded));
}

/// Where a robot believes that it is by these scans. It is at (1, 0), looks along y, and sees the wall 2.4 m
/// before its sensors.
wire::Pose2d believed(const std::string& scans) {
  MemorySite site(testing::two_eyes_world("pose [1 0 0 0] localization \"odom\" odom_error [0 0 0 0]") +
                  "model( name \"walls\" size [10 1 1] pose [0 3 0 0] )");
  EXPECT_EQ(
      site.build("driver( name \"amcl\" provides [\"localize:0\"] requires [\"position2d:0\" \"" + scans +
                 "\" \"map:0\"] init_pose [1.05 0.2 90] init_pose_var [0.1 0.2 5] sonar_range_max 7.9 )" +
                 testing::kTwoEyesStage + "driver( name \"stage\" provides [\"map:0\"] model \"walls\" )"),
      "");
  testing::see(simulation_of(site.site())->engine().world(), [](int degrees) {
    return std::min(2.4 / std::max(1e-9, std::sin(geom::radians(degrees + 90))), 8.0);
  });
  EXPECT_TRUE(site.hold(site.id(kLocalize)));
  site.run(3);
  lcl::Data newest;
  for (const device::Publication& each : site.recorder.published)
    if (each.device == site.id(kLocalize)) newest = *wire::decode<lcl::Data>(each.body);
  EXPECT_DOUBLE_EQ(newest.pending_time, 0.1) << "it took a step";
  return newest.hypoths.at(0).mean;
}

TEST(AmclScans, lead_to_the_same_pose_whatever_interface_tells_them) {
  const wire::Pose2d by_laser = believed("laser:0");
  EXPECT_NEAR(by_laser.py, 0, 0.1) << "the wall tells the distance";
  EXPECT_NEAR(by_laser.pa, geom::radians(90), geom::radians(3));
  for (const char* const scans : testing::kTwoEyes) {
    const wire::Pose2d pose = believed(scans);
    EXPECT_NEAR(pose.px, by_laser.px, 1e-4) << scans;
    EXPECT_NEAR(pose.py, by_laser.py, 1e-4) << scans;
    EXPECT_NEAR(pose.pa, by_laser.pa, 1e-4) << scans;
  }
}

TEST(AmclSection, says_what_is_wrong_and_where) {
  EXPECT_EQ(fault(chain("", "\"localize:0\"")), "") << "position2d is optional";
  EXPECT_THAT(fault(chain("", "\"position2d:2\"")),
              HasSubstr("test.cfg:1: driver \"amcl\" provides one localize and one position2d"));
  EXPECT_THAT(
      fault(chain("", "\"localize:0\"", "\"position2d:0\" \"laser:0\"")),
      HasSubstr("driver \"amcl\" requires one position2d and one laser, ranger or sonar and one map"));
  EXPECT_THAT(fault(chain("pf_min_samples 1")), HasSubstr("pf_min_samples is from 2 to 1000000"));
  EXPECT_THAT(fault(chain("pf_max_samples 50")), HasSubstr("pf_max_samples is not below pf_min_samples"));
  EXPECT_THAT(fault(chain("laser_range_bad 1")), HasSubstr("laser_range_bad is less than 1"));
  EXPECT_THAT(fault(chain("laser_range_var 0")), HasSubstr("laser_range_var is 0.001 at least"));
  EXPECT_THAT(fault(chain("init_pose_var [-1 1 0]")), HasSubstr("init_pose_var is 0 at least"));
  EXPECT_THAT(fault(chain("odom_drift[2] [0 0 -1]")), HasSubstr("odom_drift[2] is 0 at least"));
}

}  // namespace
}  // namespace playhouse::drivers
