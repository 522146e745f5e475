// The driver "wavefront" between a client and simulated robots that a test moves: what they are told, and
// when.

#include "playhouse/drivers/wavefront/wavefront.h"
#include "playhouse/bridge/simulated/simulated_world.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <limits>

#include "playhouse/base/testing_folder.h"
#include "playhouse/bridge/testing/memory_site.h"
#include "playhouse/drivers/decoded.h"
#include "playhouse/drivers/grid_map/grid_map.h"
#include "playhouse/drivers/shapes.h"
#include "playhouse/drivers/testing/refusal_of.h"
#include "playhouse/wire/codec.h"
#include "playhouse/wire/generated/position2d.h"
#include "playhouse/world/population/population.h"

namespace playhouse::drivers {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using testing::MemorySite;
namespace p2d = wire::position2d;
namespace planner = wire::planner;
using geom::Pose;
using geom::radians;

constexpr device::Address kRobot{6665, 4, 0}, kOther{6665, 4, 1}, kMap{6665, 42, 0}, kPlanner{6665, 44, 0},
    kMuteLaser{6665, 6, 0};
constexpr std::uint8_t kCmd = 2, kReq = 3;

constexpr const char* kWorld = R"(
interval_sim 100
position( name "r0" size [0.4 0.4 0.2] ranger( sensor( samples 9 fov 180 range [0 8] ) ) )
position( name "r1" size [0.4 0.4 0.2] )
)";

/// Of the robot that is told where it is.
constexpr Pose kStart{2, 1, 0, 0}, kGoal{8, 1, 0, radians(90)}, kNowhere{77, 77, 0, 0};

/// 10 x 5 m about its middle: two rooms, and a wall between them with an opening at its upper end.
GridMap rooms() {
  GridMap map{{0.125f, 80, 40, {}}, std::vector<std::int8_t>(80 * 40, -1)};
  for (std::size_t y = 0; y < 25; ++y) map.cells[y * 80 + 39] = map.cells[y * 80 + 40] = 1;
  return map;
}

std::string pgm(const GridMap& map) {
  std::string text = "P2 80 40 255";
  for (int y = 39; y >= 0; --y)
    for (int x = 0; x < 80; ++x) text += map.cells[static_cast<std::size_t>(y * 80 + x)] > 0 ? " 0" : " 255";
  return text;
}

/// A map device whose map a test may change, or that has none.
class Maps final : public device::Driver {
 public:
  std::string_view name() const override { return "maps"; }
  Result<void> start(device::DeviceId) override { return {}; }
  void stop(device::DeviceId) override {}
  device::Taken command(const device::Message&) override { return device::Taken::kNo; }
  void request(const device::Message& message, device::Replier replier) override {
    if (late && message.subtype == wire::map::kReqGetInfo) {
      waiting.push_back(std::move(replier));
    } else if (map) {
      answer_map_request(*map, message, std::move(replier));
    }
  }
  bool capable(device::DeviceId, std::uint8_t, std::uint8_t) const override { return false; }

  std::optional<GridMap> map;
  bool late = false;                     // keeps requests for its size, for the test to answer
  std::vector<device::Replier> waiting;  // for its size
};

/// The planner, from the last in the chain to the first.
std::string chain(const std::string& options, const std::string& output = "position2d:0",
                  const std::string& more = "", const std::string& after = "",
                  const std::string& scans = "") {
  return more + "driver( name \"wavefront\" provides [\"planner:0\"] requires [\"output:::" + output +
         "\" \"input:::position2d:0\" \"map:0\"" + scans + "] " + options + R"( )
driver( name "stage" provides ["simulation:0"] worldfile "some.world" )
driver( name "stage" provides ["position2d:0"] model "r0" )
driver( name "stage" provides ["position2d:1"] model "r1" )
)" + after;
}

/// A planner with a map device, open.
class Planned {
 public:
  explicit Planned(const std::string& options = "", const std::string& output = "position2d:0",
                   std::optional<GridMap> map = rooms(), const std::string& more = "",
                   const std::string& after = "", const std::string& scans = "")
      : site(kWorld) {
    maps.map = std::move(map);
    EXPECT_TRUE(site.site().add_device(kMap, maps));
    EXPECT_TRUE(site.site().add_device(kMuteLaser, mute));
    EXPECT_EQ(site.build(chain(options, output, more, after, scans)), "");
    robot_at(kStart);
    EXPECT_TRUE(site.hold(site.id(kPlanner)));
  }

  world::World& world() { return simulation_of(site.site())->engine().world(); }
  device::Driver& driver() { return site.driver(kPlanner); }
  /// Where the input says that it is; the output, too, if it is the same.
  void robot_at(const Pose& X_WR) { world().positions.X_OM[{0}] = X_WR; }
  device::Taken go_to(const Pose& goal, std::uint8_t subtype = planner::kCmdGoal) {
    return driver().command(
        {site.id(kPlanner), kCmd, subtype, wire::encode(planner::Cmd{{goal.x, goal.y, goal.a}})});
  }
  bool enable(bool on) {
    driver().request({site.id(kPlanner), kReq, planner::kReqEnable,
                      wire::encode(planner::EnableReq{static_cast<std::uint8_t>(on)})},
                     device::Replier(site.recorder, 1));
    return site.recorder.answers.at(1).ack;
  }
  planner::WaypointsReq waypoints() {
    driver().request(
        {site.id(kPlanner), kReq, planner::kReqGetWaypoints, wire::encode(planner::WaypointsReq{})},
        device::Replier(site.recorder, 2));
    return *wire::decode<planner::WaypointsReq>(site.recorder.answers.at(2).body);
  }
  /// The newest STATE.
  planner::Data state() {
    for (auto message = site.recorder.published.rbegin(); message != site.recorder.published.rend();
         ++message)
      if (message->device == site.id(kPlanner)) return *wire::decode<planner::Data>(message->body);
    ADD_FAILURE() << "no STATE";
    return {};
  }
  /// Forgets what robots were told, so that one can see whether they are told again.
  void forget() {
    std::ranges::fill(world().positions.goal, kNowhere);
    std::ranges::fill(world().positions.command, geom::Twist{9, 9, 0, 9});
  }
  /// Where a robot was told to go since forget().
  Pose told(world::PositionRow robot = {0}) {
    site.run(0);
    return world().positions.goal[robot];
  }
  std::string refusal() { return testing::refusal_of(site, kPlanner); }
  bool was_halted(world::PositionRow robot = {0}) {
    site.run(0);
    return world().positions.command[robot] == geom::Twist();
  }
  /// Gives a goal, and what it takes until the robot is told the first waypoint.
  void begin(const Pose& goal = kGoal) {
    forget();
    EXPECT_EQ(go_to(goal), device::Taken::kLatest);
    site.run(2);
  }

  Maps maps;
  testing::Mute mute;
  MemorySite site;
};

Pose pose(const wire::Pose2d& pose) {
  return {pose.px, pose.py, 0, pose.pa};
}

void expect_near(const Pose& a, const Pose& b) {
  EXPECT_NEAR(a.x, b.x, 1e-9);
  EXPECT_NEAR(a.y, b.y, 1e-9);
  EXPECT_NEAR(geom::normalize(a.a - b.a), 0, 1e-9);
}

TEST(Wavefront, says_in_the_batch_of_its_input_where_the_robot_is) {
  Planned test;
  test.site.run(1);
  std::vector<std::uint32_t> devices;
  for (const device::Publication& publication : test.site.recorder.published)
    devices.push_back(publication.device.row);
  EXPECT_THAT(devices, ElementsAre(test.site.id(kRobot).row, test.site.id(kPlanner).row));
  EXPECT_EQ(test.site.recorder.batches, 1);
  EXPECT_EQ(test.state(), (planner::Data{0, 0, {2, 1, 0}, {}, {}, -1, 0}));
  EXPECT_EQ(test.waypoints(), planner::WaypointsReq());
}

TEST(Wavefront, a_goal_becomes_a_waypoint_for_the_output_one_tick_later) {
  Planned test;
  test.forget();
  EXPECT_EQ(test.go_to(kGoal), device::Taken::kLatest);
  test.site.run(1);
  EXPECT_EQ(test.told(), kNowhere) << "the path of this tick is being planned";
  EXPECT_EQ(test.state().valid, 0);
  EXPECT_EQ(test.state().goal, pose2d(kGoal));
  test.site.run(1);
  test.site.run(1);
  const planner::Data state = test.state();
  const std::vector<wire::Pose2d> waypoints = test.waypoints().waypoints;
  EXPECT_EQ(state.valid, 1);
  EXPECT_EQ(state.done, 0);
  EXPECT_EQ(state.waypoint_idx, 0);
  EXPECT_EQ(state.waypoints_count, waypoints.size());
  EXPECT_EQ(state.waypoint, waypoints.front());
  EXPECT_EQ(test.told(), pose(waypoints.front()));
}

TEST(Wavefront, waypoints_go_round_the_wall_each_with_the_heading_of_the_next_leg) {
  Planned test("add_rotational_waypoints 0");
  test.begin();
  const planner::WaypointsReq path = test.waypoints();
  const std::vector<wire::Pose2d>& points = path.waypoints;
  ASSERT_GE(points.size(), 3u);
  EXPECT_EQ(points.back(), pose2d(kGoal));
  double length = 0;
  wire::Pose2d before = pose2d(kStart);
  for (std::size_t i = 0; i < points.size(); ++i) {
    length += std::hypot(points[i].px - before.px, points[i].py - before.py);
    before = points[i];
    if (i + 1 == points.size()) break;
    EXPECT_NEAR(points[i].pa, std::atan2(points[i + 1].py - points[i].py, points[i + 1].px - points[i].px),
                1e-9);
  }
  EXPECT_NEAR(path.waypoints_distance, length, 1e-9);
  EXPECT_GT(length, 8);
  EXPECT_GT(std::ranges::max_element(points, {}, &wire::Pose2d::py)->py, 25 * 0.125 + 0.25);
}

TEST(Wavefront, tells_each_waypoint_once_as_the_robot_reaches_the_one_before) {
  Planned test("replan_dist_thresh -1");
  test.begin();
  const std::vector<wire::Pose2d> points = test.waypoints().waypoints;
  std::vector<Pose> all_told{test.told()};
  for (int k = 0; k < 30; ++k) {
    test.robot_at(pose(test.state().waypoint));
    if (test.state().done == 1) break;
    test.forget();
    test.site.run(2);
    if (test.told() != kNowhere) all_told.push_back(test.told());
    test.forget();
    test.site.run(3);
    EXPECT_EQ(test.told(), kNowhere) << "the same waypoint again";
  }
  EXPECT_EQ(test.state().done, 1);
  EXPECT_EQ(test.state().valid, 1);
  EXPECT_EQ(test.state().waypoint_idx, -1);
  EXPECT_EQ(test.state().waypoints_count, points.size());
  EXPECT_GE(all_told.size(), 3u);
  EXPECT_EQ(all_told.back(), kGoal);
  for (const Pose& told : all_told) EXPECT_NE(std::ranges::find(points, pose2d(told)), points.end());
}

TEST(Wavefront, a_waypoint_counts_within_the_distance_and_the_goal_within_both) {
  Planned test("distance_epsilon 0.3 angle_epsilon 5 add_rotational_waypoints 0");
  test.robot_at({7, 1, 0, 0});
  test.begin();
  const auto done_at = [&test](const Pose& X_WR) {
    test.robot_at(X_WR);
    test.site.run(3);
    return test.state().done == 1;
  };
  EXPECT_FALSE(done_at({7.69, 1, 0, kGoal.a}));
  EXPECT_FALSE(done_at({7.71, 1, 0, kGoal.a + radians(5.1)}));
  EXPECT_TRUE(done_at({7.71, 1, 0, kGoal.a - radians(4.9)}));
  test.forget();
  EXPECT_TRUE(done_at({1, 1, 0, 0})) << "what is done stays done";
  EXPECT_EQ(test.told(), kNowhere);
  ASSERT_TRUE(test.site.hold(test.site.id(kRobot))) << "by somebody else";
  test.site.release(test.site.id(kPlanner));
  EXPECT_FALSE(test.was_halted()) << "the output itself goes on to the goal";
}

TEST(Wavefront, where_the_output_has_stopped_for_two_seconds_twice_as_far_counts) {
  Planned test("distance_epsilon 0.3 angle_epsilon 5 add_rotational_waypoints 0");
  test.robot_at({7, 1, 0, 0});
  test.begin();
  const auto done_after = [&test](const Pose& X_WR, int ticks) {
    test.robot_at(X_WR);
    test.site.run(ticks);
    return test.state().done == 1;
  };
  EXPECT_FALSE(done_after({7.39, 1, 0, kGoal.a}, 30)) << "too far";
  EXPECT_FALSE(done_after({7.41, 1, 0, kGoal.a + radians(9.9)}, 19));
  EXPECT_FALSE(done_after({7.41, 1.03, 0, kGoal.a + radians(9.9)}, 19)) << "it moves";
  EXPECT_TRUE(done_after({7.41, 1.03, 0, kGoal.a + radians(9.9)}, 5));
}

TEST(Wavefront, tells_the_way_again_to_an_output_that_has_stopped) {
  Planned test("replan_dist_thresh -1");
  test.begin();
  const Pose first = test.told();
  test.forget();
  test.site.run(15);
  EXPECT_EQ(test.told(), kNowhere);
  test.site.run(10);
  EXPECT_EQ(test.told(), first);
  test.enable(false);
  test.forget();
  test.site.run(50);
  EXPECT_EQ(test.told(), kNowhere) << "it is to stand";
}

TEST(Wavefront, tells_a_waypoint_that_is_near_the_one_before_too) {
  Planned test("distance_epsilon 3 angle_epsilon 180 replan_dist_thresh -1 add_rotational_waypoints 0");
  test.begin();
  const std::vector<wire::Pose2d> points = test.waypoints().waypoints;
  ASSERT_EQ(test.told(), pose(points[0]));
  ASSERT_LT(std::hypot(points[1].px - points[0].px, points[1].py - points[0].py), 1.5)
      << "half of the epsilon";
  test.robot_at({points[1].px - 3.1, points[1].py, 0, 0});
  test.site.run(2);
  EXPECT_EQ(test.told(), pose(points[1]));
}

TEST(Wavefront, turns_on_the_spot_before_a_leg_of_another_direction) {
  Planned test;
  test.robot_at({2, 1, 0, radians(-90)});
  test.begin({2.5, 4, 0, 0});
  const Pose first = test.told();
  EXPECT_EQ(first.xy(), kStart.xy());
  EXPECT_GT(first.a, radians(45));
  test.robot_at({2, 1, 0, first.a - radians(11)});
  test.site.run(2);
  EXPECT_EQ(test.told(), first);
  test.robot_at({2, 1, 0, first.a - radians(9)});
  test.site.run(2);
  EXPECT_GT(test.told().y, 1.5);

  Planned without("add_rotational_waypoints 0");
  without.robot_at({2, 1, 0, radians(-90)});
  without.begin({2.5, 4, 0, 0});
  EXPECT_GT(without.told().y, 1.5);
}

TEST(Wavefront, at_a_sharp_corner_it_turns_on_the_spot_too) {
  Planned test("distance_epsilon 0.2 replan_dist_thresh -1");
  test.begin();
  const std::vector<wire::Pose2d> points = test.waypoints().waypoints;
  std::size_t sharp = 0;
  for (std::size_t i = 1; i + 1 < points.size() && sharp == 0; ++i)
    if (std::abs(geom::normalize(points[i].pa - points[i - 1].pa)) > radians(45)) sharp = i;
  ASSERT_GT(sharp, 0u) << "the drawn map is to have one";
  Pose X_WR = pose(points[sharp]);
  for (std::size_t i = 0; i < sharp; ++i) {
    test.robot_at(pose(points[i]));
    test.site.run(2);
  }
  X_WR.a = points[sharp - 1].pa;
  test.robot_at(X_WR);
  test.site.run(3);
  EXPECT_EQ(test.state().waypoint_idx, static_cast<int>(sharp))
      << "there, but with the heading of its last leg";
  X_WR.a = points[sharp].pa;
  test.robot_at(X_WR);
  test.site.run(3);
  EXPECT_GT(test.state().waypoint_idx, static_cast<int>(sharp));
}

TEST(Wavefront, a_new_goal_takes_the_place_of_the_old_one) {
  Planned test;
  test.begin();
  const Pose other{3, 1, 0, 0};
  test.forget();
  test.go_to({8, 4, 0, 0});
  test.go_to(other);
  test.site.run(2);
  EXPECT_EQ(test.told(), other);
  test.site.run(1);
  EXPECT_EQ(test.state().goal, pose2d(other));
  EXPECT_EQ(test.waypoints().waypoints.size(), 1u);
}

TEST(Wavefront, goals_may_come_in_every_tick) {
  for (const bool moving : {false, true}) {
    Planned test;
    test.forget();
    for (int tick = 0; tick < 5; ++tick) {
      test.go_to({kGoal.x, kGoal.y, 0, moving ? kGoal.a + 0.01 * tick : kGoal.a});
      test.site.run(1);
    }
    EXPECT_NE(test.told(), kNowhere) << moving;
  }
}

TEST(Wavefront, a_goal_without_a_path_is_not_valid_and_ends_the_drive) {
  const GridMap map = rooms();
  GridMap shut = rooms();
  for (std::size_t y = 0; y < 40; ++y) shut.cells[y * 80 + 39] = 1;
  const auto halted = [](GridMap drawn, const Pose& goal) {
    Planned test("", "position2d:0", std::move(drawn));
    test.begin({3, 1, 0, 0});
    EXPECT_EQ(test.told().x, 3);
    test.begin(goal);
    test.site.run(1);
    EXPECT_EQ(test.state().valid, 0);
    EXPECT_EQ(test.state().goal, pose2d(goal));
    EXPECT_EQ(test.state().waypoint_idx, -1);
    EXPECT_EQ(test.told(), kNowhere);
    EXPECT_EQ(test.waypoints(), planner::WaypointsReq());
    const bool was_halted = test.was_halted();
    test.forget();
    test.site.run(3);
    EXPECT_FALSE(test.was_halted()) << "once";
    return was_halted;
  };
  EXPECT_TRUE(halted(map, {5, 1, 0, 0})) << "in the wall";
  EXPECT_TRUE(halted(map, {50, 1, 0, 0})) << "off the map";
  EXPECT_TRUE(halted(shut, kGoal)) << "behind the wall";
}

TEST(Wavefront, a_goal_without_a_path_does_not_stop_a_robot_that_others_drive) {
  Planned test;
  test.begin({5, 1, 0, 0});
  EXPECT_FALSE(test.was_halted());
}

TEST(Wavefront, tells_why_it_refuses_a_goal_until_it_is_given_another_one) {
  Planned test;
  EXPECT_EQ(test.refusal(), "") << "there is no goal";
  for (const auto& [goal, why] : std::vector<std::pair<Pose, std::string>>{
           {{5, 1, 0, 0}, "no path to (5, 1): the goal is within safety_dist of an obstacle"},
           {{50, 1.25, 0, 0}, "no path to (50, 1.25): the goal is off the map"},
           {kGoal, ""}}) {
    test.begin(goal);
    test.site.run(1);
    EXPECT_EQ(test.refusal(), why);
    EXPECT_EQ(test.state().valid, why.empty() ? 1 : 0);
  }
  test.go_to({50, 1, 0, 0});
  test.site.run(3);
  EXPECT_NE(test.refusal(), "");
  test.go_to(kGoal);
  EXPECT_EQ(test.refusal(), "") << "that of another goal, and no plan yet";
  test.go_to({50, 1, 0, 0});
  test.site.run(3);
  test.site.release(test.site.id(kPlanner));
  ASSERT_TRUE(test.site.hold(test.site.id(kPlanner)));
  EXPECT_EQ(test.refusal(), "") << "of who had it open before";
}

TEST(Wavefront, tells_that_it_has_no_map_and_why) {
  Planned test("", "position2d:0", std::nullopt);
  test.begin();
  test.site.run(1);
  EXPECT_EQ(test.refusal(), "no path to (8, 1): there is no map: it does not tell its size");
}

TEST(Wavefront, tells_why_its_output_does_not_drive) {
  Planned test("", "position2d:3", rooms(),
               "driver( name \"nd\" provides [\"position2d:3\"] requires [\"output:::position2d:0\" "
               "\"input:::position2d:0\" \"laser:0\"] )\n");
  EXPECT_EQ(test.go_to(kGoal), device::Taken::kLatest);
  test.site.run(3);
  const std::string of_output = "its laser does not tell its place, so it drives to no goals";
  EXPECT_EQ(testing::refusal_of(test.site, {6665, 4, 3}), of_output);
  EXPECT_EQ(test.refusal(), "its output does not go to poses: " + of_output);
}

TEST(Wavefront, tells_that_its_output_gave_up_a_waypoint) {
  Planned test("", "position2d:3", rooms(),
               "driver( name \"nd\" provides [\"position2d:3\"] requires [\"output:::position2d:0\" "
               "\"input:::position2d:0\" \"laser:1\"] )\n",
               "driver( name \"stage\" provides [\"laser:1\"] model \"r0\" )\n");
  test.world().positions.motor_on[{0}] = 1;
  std::ranges::fill(test.world().sensors.ranges, 8.0f);
  test.go_to(kGoal);
  test.site.run(10);
  EXPECT_EQ(test.refusal(), "");
  test.site.run(70);  // both wait for two seconds
  EXPECT_THAT(test.refusal(), HasSubstr("its output gave up: it gave up the goal"));
  test.go_to({7, 1, 0, 0});
  EXPECT_EQ(test.refusal(), "");
}

TEST(Wavefront, a_goal_that_had_no_path_is_planned_for_again_where_the_robot_is_elsewhere) {
  Planned test;
  test.robot_at({50, 1, 0, 0});
  test.begin();
  test.site.run(1);
  EXPECT_THAT(test.refusal(), HasSubstr("off the map"));
  test.go_to(kGoal);
  test.site.run(3);
  EXPECT_THAT(test.refusal(), HasSubstr("off the map")) << "it is where it was";
  test.robot_at(kStart);
  test.site.run(1);
  test.go_to(kGoal);
  test.site.run(3);
  EXPECT_EQ(test.refusal(), "");
  EXPECT_EQ(test.state().valid, 1);
}

TEST(Wavefront, tells_that_it_is_disabled) {
  Planned test;
  test.begin();
  EXPECT_TRUE(test.enable(false));
  EXPECT_EQ(test.refusal(), "it is disabled: ENABLE 1 lets it drive on");
  EXPECT_TRUE(test.enable(true));
  EXPECT_EQ(test.refusal(), "");
}

TEST(Wavefront, a_goal_beyond_its_numbers_is_refused_in_words) {
  Planned test;
  test.begin();
  EXPECT_EQ(test.go_to({1e300, 0, 0, 0}), device::Taken::kNo);
  EXPECT_EQ(test.refusal(), "invalid goal: a pose within 1e9 m and 1e9 rad is valid");
  test.go_to(kGoal);
  EXPECT_EQ(test.refusal(), "");
}

TEST(Wavefront, a_goal_that_is_no_place_changes_nothing) {
  Planned test;
  test.begin({3, 1, 0, 0});
  EXPECT_EQ(test.go_to({std::numeric_limits<double>::quiet_NaN(), 0, 0, 0}), device::Taken::kNo);
  test.site.run(3);
  EXPECT_EQ(test.state().goal, (wire::Pose2d{3, 1, 0}));
  EXPECT_FALSE(test.was_halted());
}

TEST(Wavefront, disabled_it_stops_and_enabled_it_goes_on) {
  Planned test;
  EXPECT_TRUE(test.enable(false));
  test.begin({3, 1, 0, 0});
  test.site.run(1);
  EXPECT_EQ(test.told(), kNowhere);
  EXPECT_EQ(test.state().valid, 1) << "it plans";
  EXPECT_TRUE(test.enable(true));
  test.site.run(2);
  EXPECT_EQ(test.told().x, 3);
  test.forget();
  EXPECT_TRUE(test.enable(false));
  EXPECT_TRUE(test.was_halted());
  test.robot_at({2.9, 1, 0, 0});
  test.site.run(3);
  EXPECT_EQ(test.told(), kNowhere);
  EXPECT_EQ(test.state().done, 0) << "it does not look where it is";
  EXPECT_EQ(test.state().goal, (wire::Pose2d{3, 1, 0}));
  test.forget();
  EXPECT_TRUE(test.enable(false));
  EXPECT_FALSE(test.was_halted()) << "the robot is no longer its own";
  test.robot_at(kStart);
  EXPECT_TRUE(test.enable(true));
  test.site.run(2);
  EXPECT_EQ(test.told().x, 3) << "told again";
}

TEST(Wavefront, start_drives_even_if_it_is_disabled) {
  Planned test;
  test.enable(false);
  test.forget();
  EXPECT_EQ(test.go_to({3, 1, 0, 0}, planner::kCmdStart), device::Taken::kLatest);
  test.site.run(2);
  EXPECT_EQ(test.told().x, 3);
}

TEST(Wavefront, plans_again_when_the_robot_has_gone_so_far_and_so_long) {
  const Pose strayed{7, 1, 0, 0};  // from where nothing is in the way
  const auto waypoints_from_there = [&](const std::string& options, int ticks) {
    Planned test(options);
    test.begin();
    test.robot_at(strayed);
    test.site.run(ticks);
    return test.waypoints().waypoints.size();
  };
  const std::size_t first = waypoints_from_there("", 0);
  EXPECT_GT(first, 1u);
  EXPECT_EQ(waypoints_from_there("", 15), first) << "not yet: 2 s";
  EXPECT_EQ(waypoints_from_there("", 25), 1u);
  EXPECT_EQ(waypoints_from_there("replan_min_time 0.5", 10), 1u);
  EXPECT_EQ(waypoints_from_there("replan_min_time 0.5 replan_dist_thresh 5.1", 15), first);
  EXPECT_EQ(waypoints_from_there("replan_dist_thresh -1", 25), first);
  EXPECT_EQ(waypoints_from_there("replan_min_time -1", 25), first);
}

TEST(Wavefront, waypoints_are_told_in_the_frame_of_the_output) {
  Planned test("", "position2d:1");
  ASSERT_TRUE(test.site.hold(test.site.id(kOther)));
  const Pose X_OR{-3, 7, 0, radians(120)};
  test.world().positions.X_OM[{1}] = X_OR;
  const Pose goal{3, 1.5, 0, radians(30)};
  test.begin(goal);
  EXPECT_EQ(test.told({0}), kNowhere);
  expect_near(compose(compose(kStart, inverse(X_OR)), test.told({1})), goal);
  // The two frames shift against each other: a little, then more than half of distance_epsilon.
  test.forget();
  test.world().positions.X_OM[{1}].x += 0.24;
  test.site.run(2);
  EXPECT_EQ(test.told({1}), kNowhere);
  test.world().positions.X_OM[{1}].x += 0.02;
  test.site.run(2);
  expect_near(compose(compose(kStart, inverse(test.world().positions.X_OM[{1}])), test.told({1})), goal);
}

TEST(Wavefront, plans_on_a_map_whose_origin_is_turned) {
  GridMap turned = rooms();
  turned.info.origin = {5, 0,
                        radians(90)};  // its rows go up, from x = 5 to x = 0; the opening is at the left
  Planned test("add_rotational_waypoints 0", "position2d:0", turned);
  test.robot_at({4, 2, 0, radians(90)});
  test.begin({4, 8, 0, 0});
  const std::vector<wire::Pose2d> points = test.waypoints().waypoints;
  ASSERT_GE(points.size(), 3u);
  EXPECT_LT(std::ranges::min_element(points, {}, &wire::Pose2d::px)->px, 5 - 25 * 0.125 - 0.25);
  for (const wire::Pose2d& point : points) {
    EXPECT_GT(point.px, 0);
    EXPECT_LT(point.px, 5);
  }
  EXPECT_EQ(points.back(), (wire::Pose2d{4, 8, 0}));
}

TEST(Wavefront, without_a_map_no_goal_is_valid) {
  Planned test("", "position2d:0", std::nullopt);
  test.begin();
  test.site.run(1);
  EXPECT_EQ(test.state().valid, 0);
  EXPECT_EQ(test.told(), kNowhere);
}

TEST(Wavefront, reads_the_map_when_it_is_opened_or_for_each_goal) {
  const auto waypoints_after_a_change = [](const std::string& options, bool reopen) {
    Planned test(options);
    test.begin();
    for (std::int8_t& cell : test.maps.map->cells) cell = -1;
    if (reopen) {
      test.site.release(test.site.id(kPlanner));
      EXPECT_TRUE(test.site.hold(test.site.id(kPlanner)));
    }
    test.begin();
    return test.waypoints().waypoints.size();
  };
  EXPECT_GT(waypoints_after_a_change("", false), 1u);
  EXPECT_EQ(waypoints_after_a_change("", true), 1u);
  EXPECT_EQ(waypoints_after_a_change("force_map_refresh 1", false), 1u);
}

TEST(Wavefront, waits_for_a_map_that_comes_late_and_takes_none_of_before_it_was_closed) {
  Planned test;
  const auto open_again = [&test] {
    test.site.release(test.site.id(kPlanner));
    test.maps.late = true;
    EXPECT_TRUE(test.site.hold(test.site.id(kPlanner)));
  };
  open_again();
  open_again();
  test.begin();
  EXPECT_EQ(test.told(), kNowhere);
  ASSERT_EQ(test.maps.waiting.size(), 2u);
  const std::vector<std::byte> size = wire::encode(test.maps.map->info);
  test.maps.waiting[0].ack(size);
  test.site.run(2);
  EXPECT_EQ(test.told(), kNowhere);
  test.maps.waiting[1].ack(size);
  test.site.run(2);
  EXPECT_NE(test.told(), kNowhere);
}

TEST(Wavefront, rewound_it_plans_again_to_its_goal) {
  Planned test;
  test.begin({3, 1, 0, 0});
  test.forget();
  static_cast<Shell&>(test.driver()).rewound({1, 0.1, 1});
  test.site.run(1);
  EXPECT_EQ(test.state().valid, 0);
  EXPECT_EQ(test.state().goal, (wire::Pose2d{3, 1, 0}));
  test.site.run(1);
  EXPECT_EQ(test.told().x, 3);
}

TEST(Wavefront, closed_on_its_way_it_leaves_a_robot_that_stands) {
  Planned test;
  ASSERT_TRUE(test.site.hold(test.site.id(kRobot))) << "by somebody else";
  test.begin();
  test.forget();
  test.site.release(test.site.id(kPlanner));
  EXPECT_TRUE(test.was_halted());
  EXPECT_EQ(test.site.held[test.site.id(kRobot).row].size(), 1u);
  EXPECT_EQ(test.site.held[test.site.id(kMap).row].size(), 0u);
  EXPECT_EQ(test.go_to(kGoal), device::Taken::kNo);
  test.forget();
  ASSERT_TRUE(test.site.hold(test.site.id(kPlanner)));
  test.site.run(3);
  EXPECT_EQ(test.told(), kNowhere) << "goals are not kept for the next who opens it";
  test.site.release(test.site.id(kPlanner));
  EXPECT_FALSE(test.was_halted()) << "it did not drive";
}

TEST(Wavefront, supports_these_messages) {
  Planned test;
  const device::DeviceId id = test.site.id(kPlanner);
  EXPECT_TRUE(test.driver().capable(id, kCmd, planner::kCmdGoal));
  EXPECT_TRUE(test.driver().capable(id, kCmd, planner::kCmdStart));
  EXPECT_TRUE(test.driver().capable(id, kReq, planner::kReqEnable));
  EXPECT_TRUE(test.driver().capable(id, kReq, planner::kReqGetWaypoints));
  EXPECT_TRUE(test.driver().capable(id, kReq, wire::kReqGetStrprop));
  EXPECT_FALSE(test.driver().capable(id, kReq, 3));
  EXPECT_FALSE(test.driver().capable(id, kCmd, 3));
  test.driver().request({id, kReq, 3, {}}, device::Replier(test.site.recorder, 5));
  EXPECT_FALSE(test.site.recorder.answers.at(5).ack);
  EXPECT_EQ(model_devices_of(test.site.site())->directory().model_of(kPlanner),
            model_devices_of(test.site.site())->directory().model_of(kRobot));
}

TEST(Wavefront, goes_with_its_robot_amid_a_drive) {
  Planned test;
  run::Simulation& simulation = *simulation_of(test.site.site());
  const device::DeviceId id = test.site.id(kPlanner);
  device::Driver& driver = test.driver();
  test.go_to(kGoal);
  test.site.run(1);
  ASSERT_TRUE(simulation.requests().post([](world::Journal& journal) { EXPECT_TRUE(journal.despawn({0})); }));
  test.site.run(3);
  test.site.run(0);  // what was said on the io thread
  EXPECT_EQ(test.site.retired.size(), 2u);
  EXPECT_EQ(test.site.hold(id).error().text, "the device has retired");
  EXPECT_EQ(driver.command({id, kCmd, planner::kCmdGoal, wire::encode(planner::Cmd{{3, 1, 0}})}),
            device::Taken::kNo);
}

TEST(Wavefront, stops_its_output_when_its_input_goes) {
  Planned test("", "position2d:1");
  test.world().positions.X_OM[{1}] = kStart;
  test.begin();
  EXPECT_NE(test.told({1}), kNowhere);
  test.forget();
  test.site.retire_device(test.site.id(kRobot));
  EXPECT_TRUE(test.was_halted({1}));
  EXPECT_EQ(test.go_to(kGoal), device::Taken::kNo);
  EXPECT_EQ(test.site.held[test.site.id(kOther).row].size(), 0u);
}

// What is not on the map.

/// The rooms with a second opening straight ahead, which the robot's beam finds free or not.
class Sighted : public ::testing::TestWithParam<const char*> {
 protected:
  static GridMap two_ways() {
    GridMap map = rooms();
    for (std::size_t y = 5; y < 11; ++y) map.cells[y * 80 + 39] = map.cells[y * 80 + 40] = -1;
    return map;
  }
  /// Of the beam straight ahead of the robot; the others see nothing.
  void sees(float range) {
    std::ranges::fill(test.world().sensors.ranges, 8.0f);
    test.world().sensors.ranges[{4}] = range;
  }

  const std::string scans = GetParam();
  Planned test{"",
               "position2d:0",
               two_ways(),
               "",
               "driver( name \"stage\" provides [\"" + scans + ":1\"] model \"r0\" )",
               " \"" + scans + ":1\""};
};

INSTANTIATE_TEST_SUITE_P(Wavefront, Sighted, ::testing::Values("laser", "ranger"),
                         [](const auto& each) { return std::string(each.param); });

TEST_P(Sighted, the_way_leads_round_what_is_seen_in_it_and_back_when_it_is_seen_no_more) {
  sees(8);
  test.begin();
  test.site.run(2);
  EXPECT_LT(test.waypoints().waypoints_distance, 6.5);
  sees(2.6f);  // at x = 4.6
  test.forget();
  test.site.run(8);
  EXPECT_GT(test.waypoints().waypoints_distance, 8);
  EXPECT_GT(test.told().a, radians(45)) << "to the other opening";
  sees(8);
  test.site.run(8);
  EXPECT_LT(test.waypoints().waypoints_distance, 6.5);
}

TEST_P(Sighted, something_is_where_the_robot_was_when_its_sensor_saw_it) {
  test.robot_at({1, 1, 0, 0});
  sees(3.6f);
  test.begin();
  test.site.run(2);
  sees(8);
  test.world().sensors.ranges[{4}] = 2.6f;
  test.robot_at({2, 1, 0, 0});
  test.site.run(10);
  EXPECT_GT(test.waypoints().waypoints_distance, 8) << "or one of the two would be seen through";
}

TEST_P(Sighted, a_goal_is_refused_only_if_something_stays_in_its_way) {
  test.maps.map = two_ways();
  for (std::size_t y = 25; y < 40; ++y) test.maps.map->cells[y * 80 + 39] = 1;
  test.site.release(test.site.id(kPlanner));
  ASSERT_TRUE(test.site.hold(test.site.id(kPlanner)));
  sees(8);
  test.begin();
  sees(2.6f);
  test.site.run(8);
  EXPECT_EQ(test.state().valid, 0);
  EXPECT_EQ(test.refusal(), "") << "it may go by itself";
  EXPECT_TRUE(test.was_halted());
  test.site.run(310);
  EXPECT_EQ(test.refusal(), "no path to (8, 1): something that is not on the map is in the way");
  sees(8);
  test.forget();
  test.site.run(8);
  EXPECT_EQ(test.refusal(), "");
  EXPECT_EQ(test.state().valid, 1);
  EXPECT_NE(test.told(), kNowhere);
}

TEST_P(Sighted, after_a_rewind_it_is_as_if_it_had_seen_nothing) {
  sees(2.6f);
  test.begin();
  test.site.run(8);
  EXPECT_GT(test.waypoints().waypoints_distance, 8);
  sees(8);
  static_cast<Shell&>(test.driver()).rewound({1, 0.1, 1});
  test.site.run(3);
  EXPECT_LT(test.waypoints().waypoints_distance, 6.5);
}

TEST(Wavefront, plans_by_the_map_alone_if_its_laser_does_not_tell_its_place) {
  Planned test("", "position2d:0", rooms(), "", "", " \"laser:0\"");
  test.begin();
  EXPECT_NE(test.told(), kNowhere);
  EXPECT_EQ(test.refusal(), "");
}

std::string fault(const std::string& cfg) {
  Maps maps;
  MemorySite site(kWorld);
  EXPECT_TRUE(site.site().add_device(kMap, maps));
  return site.build(cfg);
}

TEST(WavefrontSection, says_what_is_wrong_and_where) {
  EXPECT_THAT(fault(chain("safety_dist -0.1")), HasSubstr("test.cfg:1: safety_dist is 0 at least"));
  EXPECT_THAT(fault(chain("max_radius -1")), HasSubstr("max_radius is 0 at least"));
  EXPECT_THAT(fault(chain("dist_penalty 1001")), HasSubstr("dist_penalty is 1000 at most"));
  EXPECT_THAT(fault(chain("distance_epsilon -1")), HasSubstr("distance_epsilon is 0 at least"));
  EXPECT_THAT(fault(chain("angle_epsilon \"right\"")), HasSubstr("test.cfg:1"));
  EXPECT_EQ(
      fault("unit_length \"cm\"\n" + chain("safety_dist 25 request_map 1 cspace_file \"player.cspace\"")),
      "");
  EXPECT_THAT(
      fault("driver( name \"wavefront\" provides [\"planner:0\"] requires [\"position2d:0\" \"map:0\"] )"),
      HasSubstr(
          "test.cfg:1: driver \"wavefront\" requires one position2d of key output and one position2d of "
          "key input and one map"));
  EXPECT_THAT(fault(chain("obstacle_time -1")), HasSubstr("obstacle_time is 0 at least"));
  EXPECT_THAT(
      fault(chain("", "position2d:0", "", "", " \"laser:1\" \"ranger:0\"")),
      HasSubstr("requires one position2d of key output and one position2d of key input and one map and one "
                "laser, ranger or sonar"));
  EXPECT_THAT(fault(chain("", "position2d:7")), HasSubstr("test.cfg:1: nothing provides \"position2d:7\""));
}

TEST(WavefrontSection, plans_on_the_image_of_a_mapfile) {
  TestFolder folder;
  std::ofstream(folder / "rooms.pgm") << pgm(rooms());
  MemorySite site(kWorld);
  ASSERT_EQ(site.build(chain("") + "driver( name \"mapfile\" provides [\"map:0\"] filename \"" +
                       (folder / "rooms.pgm") + "\" resolution 0.125 origin [0 0] )"),
            "");
  simulation_of(site.site())->engine().world().positions.X_OM[{0}] = kStart;
  ASSERT_TRUE(site.hold(site.id(kPlanner)));
  device::Driver& driver = site.driver(kPlanner);
  driver.command({site.id(kPlanner), kCmd, planner::kCmdGoal, wire::encode(planner::Cmd{pose2d(kGoal)})});
  site.run(2);
  driver.request({site.id(kPlanner), kReq, planner::kReqGetWaypoints, {}}, device::Replier(site.recorder, 1));
  Planned same;
  same.begin();
  EXPECT_EQ(*wire::decode<planner::WaypointsReq>(site.recorder.answers.at(1).body), same.waypoints());
}

}  // namespace
}  // namespace playhouse::drivers
