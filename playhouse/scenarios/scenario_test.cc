#include "playhouse/scenarios/scenario.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>

#include "playhouse/scenarios/embedded.h"
#include "playhouse/scenarios/start_poses.h"
#include "playhouse/scene/testing_expanded.h"
#include "playhouse/scene/world_loader.h"

namespace playhouse::scenarios {
namespace {

/// Smallest distance between two of some points; the oracle sorts by x and looks along it.
double nearest_pair(std::vector<geom::Pose> poses) {
  std::sort(poses.begin(), poses.end(), [](const geom::Pose& a, const geom::Pose& b) { return a.x < b.x; });
  double nearest = 1e9;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    for (std::size_t k = i + 1; k < poses.size() && poses[k].x - poses[i].x < nearest; ++k) {
      nearest = std::min(nearest, std::hypot(poses[k].x - poses[i].x, poses[k].y - poses[i].y));
    }
  }
  return nearest;
}

std::vector<geom::Pose> robot_poses(const scene::SceneDesc& scene) {
  std::vector<geom::Pose> poses;
  for (const scene::TreeDesc& tree : scene.trees) {
    if (scene.models[tree.top].kind == scene::ModelKind::kPosition) poses.push_back(tree.X_WM);
  }
  return poses;
}

void expect_no_overlaps(std::string_view name, std::size_t robots) {
  const Result<scene::SceneDesc> scene = make(name, robots);
  ASSERT_TRUE(scene) << scene.error().line();
  const std::vector<geom::Pose> poses = robot_poses(*scene);
  const bool is_mixed = name == "mixed";
  ASSERT_EQ(poses.size(), robots + (is_mixed ? 5 : 0));
  const double radius = name == "diffusion"           ? 0.085
                        : name == "swarm" || is_mixed ? 0.05 * std::sqrt(2.0)
                                                      : kRobotRadius;
  EXPECT_GE(nearest_pair(poses), 2 * radius - 1e-9) << name << " with " << robots;
}

TEST(Scenario, holds_any_number_of_robots_without_overlaps) {
  for (const Scenario& scenario : kScenarios) {
    for (const std::size_t robots : {1, 2, 3, 5, 10, 99, 100, 101, 150, 1000, 5000}) {
      expect_no_overlaps(scenario.name, robots);
    }
  }
}

RC_GTEST_PROP(Scenario, keeps_robots_apart_and_inside_the_walls, ()) {
  const auto count = *rc::gen::inRange<std::size_t>(1, 3000);
  const double side = std::sqrt(static_cast<double>(count) / kDensity);
  const std::vector<geom::Pose> poses = in_square(count, side);
  RC_ASSERT(poses.size() == count);
  RC_ASSERT(nearest_pair(poses) >= 2 * kRobotRadius - 1e-9);
  for (const geom::Pose& pose : poses) {
    RC_ASSERT(std::max(std::fabs(pose.x), std::fabs(pose.y)) <= side / 2 - kRobotRadius + 1e-9);
  }
}

TEST(Scenario, has_room_for_the_most_robots) {
  const double side = std::sqrt(static_cast<double>(kMostRobots) / kDensity);
  EXPECT_EQ(in_square(kMostRobots, side).size(), kMostRobots);
  const auto rock = scene::decode_bitmap(embedded_files().at("worlds/bitmaps/cave.png"));
  ASSERT_TRUE(rock);
  EXPECT_GE(in_cave(kMostRobots, *rock, 16).size(), 100u) << "as many as start in a cave";
}

TEST(Scenario, starts_no_robot_in_the_rock) {
  const auto rock = scene::decode_bitmap(embedded_files().at("worlds/bitmaps/cave.png"));
  ASSERT_TRUE(rock);
  const double pixel = 16.0 / rock->width;
  const int reach = static_cast<int>(kRobotRadius / pixel);
  for (const geom::Pose& pose : in_cave(100, *rock, 16)) {
    const int x = static_cast<int>((pose.x + 8) / pixel), y = static_cast<int>((8 - pose.y) / pixel);
    for (int v = -reach; v <= reach; ++v) {
      for (int u = -reach; u <= reach; ++u) {
        if (u * u + v * v <= reach * reach) {
          ASSERT_FALSE(rock->at(x + u, y + v));
        }
      }
    }
  }
}

TEST(Hospital, starts_no_robot_in_a_wall_and_has_12_robots_for_each_ward) {
  for (const std::size_t robots : {1, 12, 13, 500}) {
    const auto scene = make("hospital", robots);
    ASSERT_TRUE(scene) << scene.error().line();
    std::size_t wards = 0;
    for (const scene::TreeDesc& tree : scene->trees) {
      if (!tree.name.starts_with("room")) continue;
      ++wards;
      for (const geom::Pose& robot : robot_poses(*scene))
        for (const scene::Block& block : scene->models[tree.top].blocks) {
          geom::Box box;
          for (const geom::Vec2 p : block.points) box.add({p.x + tree.X_WM.x, p.y + tree.X_WM.y});
          ASSERT_FALSE(robot.x > box.x_min - 0.2 && robot.x < box.x_max + 0.2 && robot.y > box.y_min - 0.2 &&
                       robot.y < box.y_max + 0.2)
              << tree.name << ", " << robots;
        }
    }
    EXPECT_GE(wards * 12, robots);
    EXPECT_LE(wards, 2 * (robots / 12 + 1));
  }
}

TEST(Scenario, has_the_sensors_and_controllers_it_names) {
  auto sonar = make("sonar", 2), laser = make("laser", 2), cave = make("cave", 2);
  ASSERT_TRUE(sonar && laser && cave);
  for (auto* scene : {&sonar, &laser, &cave}) **scene = scene::expanded(std::move(**scene));
  const auto part = [](const scene::SceneDesc& scene, std::string_view name) {
    return std::find_if(scene.models.begin(), scene.models.end(),
                        [&](const auto& m) { return m.name == name; });
  };
  EXPECT_EQ(part(*sonar, "r1")->ctrl, std::vector<std::string>{"expand_swarm"});
  EXPECT_EQ(part(*sonar, "r1.ranger:0")->sensors.size(), 16u);
  EXPECT_EQ(part(*sonar, "r1.ranger:0")->sensors[0].range_max, 5);
  EXPECT_EQ(part(*laser, "r1")->ctrl, std::vector<std::string>{"wander"});
  EXPECT_EQ(part(*laser, "r1.ranger:0")->sensors[0].samples, 180u);
  EXPECT_EQ(part(*laser, "r1.ranger:0")->sensors[0].range_max, 8);
  EXPECT_NEAR(part(*laser, "r1.ranger:0")->sensors[0].fov, geom::kPi, 1e-12);
  EXPECT_EQ(part(*cave, "r1")->ctrl, std::vector<std::string>{"expand_pioneer"});
  EXPECT_EQ(part(*cave, "r1.ranger:1")->parent, part(*cave, "r1") - cave->models.begin());
  EXPECT_FALSE(part(*cave, "room0")->bitmaps.empty());
  EXPECT_EQ(part(*sonar, "r1")->blocks[0].points.size(), 8u);
  auto hospital = make("hospital", 2), diffusion = make("diffusion", 2), swarm = make("swarm", 2),
       mixed = make("mixed", 2);
  ASSERT_TRUE(hospital && diffusion && swarm && mixed);
  for (auto* scene : {&hospital, &diffusion, &swarm, &mixed}) **scene = scene::expanded(std::move(**scene));
  EXPECT_EQ(part(*hospital, "r1.ranger:0")->sensors.size(), 12u);
  for (const auto* scene : {&swarm, &mixed}) EXPECT_EQ(part(**scene, "r1.ranger:0")->sensors.size(), 12u);
  EXPECT_EQ(part(*mixed, "base")->size.x, 60);
  EXPECT_EQ(part(*diffusion, "r1.ranger:0")->sensors[0].samples, 24u);
  EXPECT_NEAR(part(*diffusion, "r1.ranger:0")->sensors[0].range_max, 0.085 + 0.1, 1e-12);
  for (const auto* scene : {&sonar.value(), &laser.value(), &cave.value(), &hospital.value(),
                            &diffusion.value(), &swarm.value(), &mixed.value()}) {
    EXPECT_TRUE(scene->warnings.empty()) << scene->warnings[0];
    EXPECT_EQ(scene->interval, 0.1);
  }
}

TEST(Scenario, refuses_what_it_can_not_make) {
  EXPECT_EQ(make("sonr", 5).error().line(), "no scenario \"sonr\" (did you mean \"sonar\"?)");
  EXPECT_FALSE(make("sonar", 0));
  EXPECT_FALSE(make("cave", kMostRobots + 1));
}

TEST(Worlds, of_ours_load_without_a_warning) {
  for (const char* file : {"worlds/cave.world", "worlds/simple.world", "worlds/square.world",
                           "worlds/fiducial.world", "worlds/swarm.world", "examples/controller/shy.world"}) {
    const auto scene = scene::load_world(std::string(PLAYHOUSE_SOURCE_DIR) + "/" + file);
    ASSERT_TRUE(scene) << scene.error().line();
    EXPECT_TRUE(scene->warnings.empty()) << scene->warnings[0];
  }
}

}  // namespace
}  // namespace playhouse::scenarios
