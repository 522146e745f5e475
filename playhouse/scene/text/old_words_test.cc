/// Worlds of Stage 1 to 3: what their words and types become, and what is said of them.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "playhouse/scene/kinds.h"
#include "playhouse/scene/testing_same_scene.h"
#include "playhouse/scene/world_loader.h"
#include "playhouse/scene/write_world.h"

namespace playhouse::scene {
namespace {

using ::testing::AllOf;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::SizeIs;

SceneDesc loaded(const std::string& text) {
  config::MemoryFiles files({{"w/plan", std::string("P1 4 3 1111 1001 1101")}});
  auto scene = load_world_text(text, "w/t.world", files);
  EXPECT_TRUE(scene) << scene.error().line();
  return scene ? std::move(*scene) : SceneDesc();
}

std::string error_of(const std::string& text) {
  config::MemoryFiles files({});
  const auto scene = load_world_text(text, "w/t.world", files);
  return scene ? "" : scene.error().line();
}

/// The same scene but for its warnings and lines.
std::string difference_of(const std::string& old, const std::string& now) {
  SceneDesc a = loaded(old);
  const SceneDesc b = loaded(now);
  EXPECT_THAT(b.warnings, IsEmpty()) << now;
  EXPECT_THAT(a.warnings, Not(IsEmpty())) << old;
  return difference(a, b);
}

TEST(OldWords, a_laser_is_a_ranger_with_one_sensor) {
  EXPECT_EQ(difference_of("laser()", "ranger( sensor( range [0 8] fov 180 samples 180 ) )"), "");
  EXPECT_EQ(difference_of("laser( range_max 4 range_min 0.5 fov 90 samples 7 size [0.1 0.1 0.2] )",
                          "ranger( size [0.1 0.1 0.2] sensor( range [0.5 4] fov 90 samples 7 ) )"),
            "");
}

TEST(OldWords, of_an_instance_count_before_those_of_its_macro) {
  EXPECT_EQ(difference_of("define sick laser( range_max 8 samples 361 )\nposition( sick( samples 90 ) )",
                          "define sick ranger()\n"
                          "position( sick( sensor( range [0 8] fov 180 samples 90 ) ) )"),
            "");
}

TEST(OldWords, a_ring_of_sonars_has_a_sensor_for_each_pose) {
  const std::string now =
      "ranger( sensor( pose [0.1 0.2 0 90] range [0.1 5] fov 15 size [0.01 0.05 0.02] )\n"
      "sensor( pose [0.3 0 0 -10] range [0.1 5] fov 15 size [0.01 0.05 0.02] ) )";
  const std::string words = "( scount 2 spose[0] [0.1 0.2 90] spose[1] [0.3 0 -10] ssize [0.01 0.05] ";
  EXPECT_EQ(difference_of("ranger" + words + "sview [0.1 5 15] )", now), "");
  EXPECT_EQ(difference_of("sonar" + words + "srange [0.1 5] )", now), "");
}

TEST(OldWords, with_a_number_are_of_one_sensor_and_without_of_all) {
  EXPECT_EQ(difference_of("ranger( scount 3 sview [0 2 30] sview[1] [0 4 10] )",
                          "ranger( sensor( range [0 2] fov 30 ) sensor( range [0 4] fov 10 ) "
                          "sensor( range [0 2] fov 30 ) )"),
            "");
}

TEST(OldWords, that_are_not_counted_or_missing_are_told) {
  EXPECT_THAT(loaded("ranger( scount 2 spose[0] [0 0 0] spose[1] [0 0 90]\nspose[5] [0 0 180] )").warnings,
              Contains("w/t.world:2: \"spose[5]\" has no effect: there are 2"));
  EXPECT_THAT(loaded("ranger( scount 2 spose[0] [1 0 0] )").warnings,
              Contains("w/t.world:1: \"scount\" is 2, but \"spose[1]\" is missing; what is missing is in the "
                       "middle"));
  EXPECT_THAT(loaded("ranger( scount 2 spose [1 0 0] sview[1] [0 5 15] )").warnings,
              Not(Contains(HasSubstr("is missing"))));
}

TEST(OldWords, are_left_alone_where_a_ranger_has_sensors_in_todays_words) {
  const SceneDesc scene = loaded("define eye sensor( samples 5 )\nranger( samples 32 eye() )");
  ASSERT_THAT(scene.models[0].sensors, SizeIs(1));
  EXPECT_EQ(scene.models[0].sensors[0].samples, 5u);
  EXPECT_THAT(
      scene.warnings,
      ElementsAre("w/t.world:2: \"samples\" of ranger has no effect: it belongs into a sensor( ... )"));
}

TEST(OldWords, in_a_sensor_are_its_range) {
  EXPECT_EQ(difference_of("ranger( sensor( range_max 30 ) sensor( view [1 2 90] ) )",
                          "ranger( sensor( range [0 30] ) sensor( range [1 2] fov 90 ) )"),
            "");
}

TEST(OldWords, of_today_in_the_same_entity_count_before_old_ones) {
  EXPECT_EQ(difference_of("model( laser_return 0 ranger_return 0.5 )", "model( ranger_return 0.5 )"), "");
}

TEST(OldWords, what_lasers_saw_through_rangers_see_through) {
  EXPECT_EQ(difference_of("model( laser_return 0 )\nmodel( laser_return 2 )",
                          "model( ranger_return -1 )\nmodel( ranger_return 2 )"),
            "");
}

TEST(OldWords, poses_and_sizes_had_no_height) {
  EXPECT_EQ(
      difference_of("position( pose [1 2 90] size [0.3 0.2] origin [-0.1 0 0] )",
                    "position( pose [1 2 0 90] size [0.3 0.2 1] origin [-0.1 0 0 0] stack_children 0 )"),
      "");
}

TEST(OldWords, parts_of_what_has_no_height_are_at_its_foot) {
  const SceneDesc scene = loaded("position( size [0.4 0.3] laser( size [0.1 0.1] ) )\nposition( laser() )");
  EXPECT_EQ(scene.models[1].X_PM.z, 0) << "it sees walls that are as high as the robot";
  EXPECT_EQ(scene.models[3].X_PM.z, 1) << "as in Stage 4";
}

TEST(OldWords, velocities_and_errors_had_no_z) {
  EXPECT_EQ(difference_of("position( velocity [0.1 0.2 30] odom_error [0.03 0.02 0.05] )",
                          "position( velocity [0.1 0.2 0 30] odom_error [0.03 0.02 0 0.05] )"),
            "");
}

TEST(OldWords, a_map_is_a_model_with_walls_around_it) {
  EXPECT_EQ(
      difference_of(
          "map( bitmap \"plan\" size [40 18] )",
          "model( bitmap \"plan\" size [40 18 1] boundary 1 color \"gray30\" gui_move 0 stack_children 0 )"),
      "");
  EXPECT_EQ(difference_of("map( bitmap \"plan\" size [40 18 1] color \"red\" )",
                          "model( bitmap \"plan\" size [40 18 1] boundary 1 color \"red\" gui_move 0 )"),
            "");
}

TEST(OldWords, devices_without_a_body_are_left_out) {
  EXPECT_EQ(difference_of("player( port 6665 )\nposition( player() truth() laser( samples 5 ) )",
                          "position( ranger( sensor( range [0 8] fov 180 samples 5 ) ) )"),
            "");
}

TEST(OldWords, polygons_are_blocks) {
  EXPECT_EQ(difference_of("model( polygons 2 polygon[0].points 3 polygon[0].point[0] [0 0] "
                          "polygon[0].point[1] [1 0] polygon[0].point[2] [0 1] polygon[0].filled 1\n"
                          "polygon[1].points 3 polygon[1].point[0] [1 1] polygon[1].point[1] [1 0] "
                          "polygon[1].point[2] [0 1] )",
                          "model( block( points 3 point[0] [0 0] point[1] [1 0] point[2] [0 1] z [0 1] )\n"
                          "block( points 3 point[0] [1 1] point[1] [1 0] point[2] [0 1] z [0 1] ) )"),
            "");
}

TEST(OldWords, of_blobfinders_and_fiducial_finders_have_other_names) {
  EXPECT_EQ(difference_of("vision( channel_count 2 channels [\"red\" \"green\"] range_max 3 ptz [10 0 70] )\n"
                          "fiducialfinder( range 4 )",
                          "blobfinder( colors_count 2 colors [\"red\" \"green\"] range 3 pan 10 fov 70 )\n"
                          "fiducial( range_max 4 )"),
            "");
}

TEST(OldWords, of_the_world_and_its_window_are_read) {
  const SceneDesc scene = loaded("interval_sim 100\ninterval_real 50\nwindow( scale 0.02 )");
  EXPECT_EQ(scene.speedup, 2);
  EXPECT_EQ(scene.window.scale, 50);
  EXPECT_EQ(loaded("interval_real 0").speedup, -1) << "as fast as possible";
  EXPECT_EQ(loaded("interval_real 50 speedup 4").speedup, 4);
  EXPECT_EQ(loaded("window( scale 20 )").window.scale, 20);
}

TEST(OldWords, defaults_are_in_the_units_of_the_file) {
  const SceneDesc scene = loaded("unit_length \"cm\"\nunit_angle \"radians\"\nlaser()");
  EXPECT_DOUBLE_EQ(scene.models[0].sensors[0].range_max, 8);
  EXPECT_DOUBLE_EQ(scene.models[0].sensors[0].fov, geom::kPi);
}

TEST(OldWords, have_one_warning_each_with_the_first_line_and_how_many_more) {
  const SceneDesc scene = loaded(
      "define robot position( pose [0 0 0] laser( samples 10 ) )\nrobot()\nrobot( pose [1 0 0] )\n"
      "laser()\nrobot( pose [2 0 0] )\nmodel( laser_return 1 )");
  EXPECT_THAT(
      scene.warnings,
      ::testing::UnorderedElementsAre(
          "w/t.world:1: \"pose\" without z is of older versions: write [x y z heading] (and on 2 lines "
          "more)",
          AllOf(HasSubstr("w/t.world:1: \"laser\" is a type of older versions: write ranger("),
                HasSubstr("(and on 1 line more)")),
          "w/t.world:1: \"samples\" of ranger is of older versions: it belongs into a sensor( ... )",
          HasSubstr("w/t.world:6: \"laser_return\" of model is of older versions: write ranger_return")));
}

TEST(OldWords, are_counted_however_many_trees_are_alike) {
  std::string text;
  for (int k = 0; k < 100; ++k) text += "position( pose [" + std::to_string(k) + " 0 0] laser() )\n";
  const SceneDesc scene = loaded(text);
  EXPECT_EQ(scene.models.size(), 2u) << "they share a description";
  EXPECT_THAT(scene.warnings,
              ElementsAre(HasSubstr("(and on 99 lines more)"), HasSubstr("(and on 99 lines more)")));
}

TEST(OldWords, make_no_more_parts_than_a_world_may_have) {
  EXPECT_THAT(error_of("ranger(\nscount 1000000 )"),
              HasSubstr("w/t.world:2: old words tell of too many parts"));
  EXPECT_THAT(error_of("model( polygon[4000000000].points 3 )"), HasSubstr("too many parts"));
  EXPECT_EQ(error_of("ranger( scount -3 )"), "");
  EXPECT_EQ(error_of("ranger( scount \"many\" spose[99999999999] [0 0 0] )"), "");
}

TEST(OldWords, mean_sensors_where_a_macro_has_that_name) {
  const SceneDesc scene = loaded("define sensor model()\ndefine block model()\nlaser( samples 3 )");
  ASSERT_THAT(scene.models, SizeIs(1));
  EXPECT_THAT(scene.models[0].sensors, SizeIs(1));
}

TEST(OldWords, that_are_macros_or_unknown_types_stay_so) {
  EXPECT_EQ(loaded("define laser ranger( sensor( samples 4 ) )\nlaser()").models[0].sensors[0].samples, 4u);
  EXPECT_THAT(error_of("driver()"), HasSubstr("unknown model type \"driver\""));
}

constexpr const char* kOldWorld = R"(
size [16 16]
resolution 0.02
interval_sim 100
interval_real 100
gui_interval 20
window( size [600 600] center [-0.01 -0.04] scale 0.028 rangerdata 1 )
define p2dx_sonar ranger(
  scount 16
  spose[0] [ 0.075 0.130 90 ]   spose[1] [ 0.115 0.115 50 ]   spose[2] [ 0.150 0.080 30 ]
  spose[3] [ 0.170 0.025 10 ]   spose[4] [ 0.170 -0.025 -10 ] spose[5] [ 0.150 -0.080 -30 ]
  spose[6] [ 0.115 -0.115 -50 ] spose[7] [ 0.075 -0.130 -90 ] spose[8] [ -0.155 -0.130 -90 ]
  spose[9] [ -0.195 -0.115 -130 ] spose[10] [ -0.230 -0.080 -150 ] spose[11] [ -0.250 -0.025 -170 ]
  spose[12] [ -0.250 0.025 170 ] spose[13] [ -0.230 0.080 150 ] spose[14] [ -0.195 0.115 130 ]
  spose[15] [ -0.155 0.130 90 ]
  sview [0 5.0 15] ssize [0.01 0.05] )
define sicklaser laser( range_min 0.0 range_max 8.0 fov 180 samples 361 color "blue" size [ 0.14 0.14 ] )
define pioneer2dx position(
  size [0.44 0.33] origin [-0.04 0.0 0] gui_nose 1 drive "diff"
  polygons 1 polygon[0].points 4
  polygon[0].point[0] [ 0.23 0.05 ] polygon[0].point[1] [ 0.15 0.15 ]
  polygon[0].point[2] [ -0.15 0.15 ] polygon[0].point[3] [ -0.23 -0.05 ]
  p2dx_sonar() )
map( bitmap "plan" size [16 16] name "cave" )
pioneer2dx( name "r0" color "red" pose [-6 -6 45] velocity [0.2 0 0 10] sicklaser( pose [0.04 0 0] samples 180 ) truth() )
pioneer2dx( name "r1" color "blue" pose [2 2 90] laser() ptz( ptz [10 0 60] ) )
puck( pose [1 1 0] )
)";

TEST(OldWorld, is_written_in_todays_words_as_the_same_scene) {
  const SceneDesc scene = loaded(kOldWorld);
  const auto text = write_world(scene, scene.path);
  ASSERT_TRUE(text);
  const SceneDesc again = loaded(*text);
  EXPECT_EQ(difference(scene, again), "") << *text;
  for (const std::string& warning : again.warnings) EXPECT_THAT(warning, HasSubstr("not simulated yet"));
  EXPECT_EQ(again.models[static_cast<std::size_t>(2)].sensors.size(), 16u);
}

TEST(OldWords, say_what_to_write) {
  for (const Kind& kind : kinds())
    for (const Word& word : kind.words)
      if (word.meaning) {
        EXPECT_FALSE(word.instead.empty()) << kind.name << ": " << word.name;
      }
}

}  // namespace
}  // namespace playhouse::scene
