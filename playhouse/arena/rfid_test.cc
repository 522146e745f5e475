// What readers of radio tags tell, against geometry, in both engines.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "playhouse/arena/testing_runs.h"

namespace playhouse::arena {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

/// With its middle 0.1 m above the floor, as of a tag below.
constexpr const char* kReader = "rfid( size [0.1 0.2 0.2] alwayson 1 update_interval 20 ";

struct Scene : EngineRun {
  explicit Scene(const std::string& text, bool arena = false, unsigned workers = 1)
      : EngineRun("interval_sim 20\n" + text, arena, workers) {
    step(2);
  }
  std::vector<std::string> read(std::uint32_t row = 0) {
    std::vector<std::string> names;
    for (const world::TagInRange& tag : world().rfids.tags[{row}])
      names.push_back(world().name(world().row(tag.target)));
    return names;
  }
  double range(std::size_t k = 0) { return world().rfids.tags[{0}].at(k).range; }
};

/// A body of 0.2 m that nothing meets.
std::string tag(const std::string& name, const std::string& words) {
  return "model( name \"" + name + "\" size [0.2 0.2 0.2] obstacle_return 0 rfid_tag \"" + "E2 00" + "\" " +
         words + " )\n";
}

TEST(RfidSense, reads_tags_in_range_and_no_other_models) {
  for (const bool arena : {false, true}) {
    Scene run(std::string(kReader) + "range_max 2.5 )\n" + tag("near", "pose [1.2 1.6 0 0]") +
                  tag("far", "pose [1.6 2 0 0]") + "model( name \"bare\" pose [0 -1 0 0] )",
              arena);
    EXPECT_THAT(run.read(), ElementsAre("near")) << arena;
    EXPECT_NEAR(run.range(), 2, 1e-6) << arena;
  }
}

TEST(RfidSense, measures_in_space_from_middle_to_middle) {
  for (const bool arena : {false, true}) {
    // 3-4-5, between middles of bodies of another height and another origin.
    Scene run(std::string(kReader) + "range_max 0.6 pose [0 0 1 0] )\n" +
                  tag("above", "pose [0.3 0 0 0] size [0.2 0.2 1.4] origin [0.1 0 0 0]") +
                  tag("below", "pose [0 0.5 0 0]"),
              arena);
    EXPECT_THAT(run.read(), ElementsAre("above")) << arena;
    EXPECT_NEAR(run.range(), std::hypot(0.4, 0.4), 1e-6) << arena;
  }
}

TEST(RfidSense, reads_within_the_cone_about_its_axis) {
  for (const bool arena : {false, true}) {
    const std::string tags = tag("ahead", "pose [1 0 0 0]") + tag("aside", "pose [1 0.99 0 0]") +
                             tag("outside", "pose [-1 -1.01 0 0]") + tag("behind", "pose [-1 0 0 0]");
    EXPECT_THAT(Scene(std::string(kReader) + "fov 90 )\n" + tags, arena).read(),
                ElementsAre("ahead", "aside"));
    EXPECT_THAT(Scene(std::string(kReader) + "fov 90 pose [0 0 0 180] )\n" + tags, arena).read(),
                ElementsAre("behind"));
    EXPECT_EQ(Scene(std::string(kReader) + ")\n" + tags, arena).read().size(), 4u) << "all around";
    EXPECT_THAT(Scene(std::string(kReader) + "fov 90 )\n" + tag("high", "pose [0.5 0 0.6 0]"), arena).read(),
                IsEmpty());
  }
}

TEST(RfidSense, a_tilted_reader_reads_where_its_axis_points) {
  // Its front down by 60 degrees.
  const std::string text = std::string(kReader) + "range_max 3 fov 40 tilt [0 60] pose [0 0 2 0] )\n" +
                           tag("floor", "pose [1.1 0 0 0]") + tag("level", "pose [1.5 0.4 2 0]");
  EXPECT_THAT(Scene(text, true).read(), ElementsAre("floor"));
  EXPECT_THAT(Scene(text, false).read(), ElementsAre("level")) << "upright";
}

TEST(RfidSense, each_wall_divides_the_range) {
  for (const bool arena : {false, true}) {
    // Two walls of 6 dB: 2 m / 10^(12/20) = 0.502 m.
    for (const double distance : {0.49, 0.51}) {
      const std::string at = std::to_string(distance);
      Scene run(
          std::string(kReader) + "range_max 2 wall_factor 6 )\n" + tag("t", "pose [" + at + " 0 0 0]") +
              "define wall model( size [0.02 4 2] )\nwall( pose [0.2 0 0 0] )\nwall( pose [0.3 0 0 0] )\n",
          arena);
      EXPECT_EQ(run.read().size(), distance < 0.5 ? 1u : 0u) << distance << arena;
    }
    Scene through(std::string(kReader) + "wall_factor 0 )\n" + tag("t", "pose [1.9 0 0 0]") +
                      "model( pose [1 0 0 0] size [0.1 4 2] )",
                  arena);
    EXPECT_THAT(through.read(), ElementsAre("t")) << arena;
  }
}

TEST(RfidSense, the_bodies_that_carry_the_reader_and_the_tag_are_no_walls) {
  for (const bool arena : {false, true}) {
    Scene run(
        "model( name \"gate\" size [0.5 0.5 1] rfid( name \"reader\" pose [0 0 -0.9 0] alwayson 1 "
        "range_max 2 wall_factor 40 ) )\n"
        "model( name \"shelf\" pose [1.5 0 0 0] size [0.5 1 1] "
        "model( name \"box\" pose [0 0 -0.9 0] size [0.2 0.2 0.2] rfid_tag \"01\" ) )",
        arena);
    run.step(5);
    EXPECT_THAT(run.read(), ElementsAre("shelf.box")) << arena;
  }
}

TEST(RfidSense, reads_what_its_own_robot_carries_but_not_itself) {
  for (const bool arena : {false, true}) {
    Scene run("position( name \"r\" size [0.4 0.4 0.2] rfid_tag \"02\" " + std::string(kReader) +
                  "rfid_tag \"03\" ) model( name \"box\" size [0.1 0.1 0.1] rfid_tag \"04\" ) )",
              arena);
    EXPECT_THAT(run.read(), ElementsAre("r", "r.box")) << arena;
  }
}

TEST(RfidSense, a_tag_comes_into_range_with_the_robot_that_carries_the_reader_and_goes_with_its_model) {
  for (const bool arena : {false, true}) {
    Scene run("position( name \"r\" size [0.4 0.4 0.2] alwayson 1 velocity [0.5 0 0 0] " +
                  std::string(kReader) + "pose [0 0 -0.2 0] range_max 1 ) )\n" + tag("t", "pose [2 0 0 0]"),
              arena);
    EXPECT_THAT(run.read(), IsEmpty()) << arena;
    run.step(120);  // 2.4 s: 1.2 m
    ASSERT_THAT(run.read(), ElementsAre("t")) << arena;
    EXPECT_NEAR(run.range(), 2 - run.world().models.X_WM[run.world().find("r")].x, 1e-6) << arena;
    ASSERT_TRUE(world::despawn(run.world(), run.world().id(run.world().find("t"))).ok());
    run.step();
    EXPECT_THAT(run.read(), IsEmpty()) << arena;
  }
}

TEST(RfidSense, reads_the_same_with_any_number_of_workers) {
  std::string text;
  for (int k = 0; k < 200; ++k) {
    const std::string at =
        std::to_string(k % 20) + " " + std::to_string(k / 20) + " 0 " + std::to_string(7 * k);
    text += std::string(kReader) + "range_max 3 fov 200 pose [" + at + "] )\n" +
            tag("t" + std::to_string(k), "pose [" + at + "]");
  }
  Scene run(text), again(text, false, 4);
  EXPECT_GT(run.world().rfids.tags[{7}].size(), 5u);
  EXPECT_EQ(run.world().sensed_hash(), again.world().sensed_hash());
}

}  // namespace
}  // namespace playhouse::arena
