// What motes measure, and which of them a base station hears, in both engines.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "playhouse/arena/testing_runs.h"
#include "playhouse/scene/write_world.h"
#include "playhouse/senses/radio.h"
#include "playhouse/world/changes/journal.h"
#include "playhouse/world/saving/as_scene.h"

namespace playhouse::arena {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

const std::string kBase = "mote( base 1 alwayson 1 update_interval 20 range 10 ";

struct Session : EngineRun {
  explicit Session(const std::string& text, bool arena = false, unsigned workers = 1)
      : EngineRun("interval_sim 20\n" + text, arena, workers) {}
  const world::Motes& motes() { return world().motes; }
  /// Ids of the motes that the first one, a base station, has in reach.
  std::vector<std::uint32_t> in_reach() {
    std::vector<std::uint32_t> ids;
    for (const world::MoteLink& link : motes().links[{0}]) ids.push_back(link.station.value);
    return ids;
  }
  /// How many of them it heard in this tick.
  std::ptrdiff_t heard() {
    return std::ranges::count_if(motes().links[{0}], [](const auto& link) { return link.heard != 0; });
  }
};

std::string mote(const std::string& words) {
  return "mote( update_interval 20 " + words + " )\n";
}

TEST(MoteSense, measures_the_air_its_weight_and_its_battery) {
  for (const bool arena : {false, true}) {
    Session run(
        kBase + ")\n" +
            "model( size [0.2 0.2 0.2] obstacle_return 0 joules 250 joules_capacity 1000 pose [3 4 0 0]\n" +
            "mote( pose [0 0 -0.11 0] update_interval 20 ambient 10 lapse 2 volts [2 3] ) )\n" +
            "model( size [0.2 0.2 0.2] obstacle_return 0 heat 30 heat_radius 0.5 )\n" +
            mote("pose [1 0 2 0]"),
        arena);
    run.step(2);
    // On the box, the middle of its body is at 0.1 m, as high as that of the warm one, and 5 m away.
    EXPECT_NEAR(run.motes().temperature[{1}], 10 - 2 * 0.1 + 30 * 0.5 / 5, 1e-9) << arena;
    EXPECT_NEAR(run.motes().acceleration[{1}].z, run.world().scene().gravity, 1e-6) << arena;
    EXPECT_NEAR(run.motes().acceleration[{1}].x, 0, 1e-6) << arena;
    EXPECT_NEAR(run.motes().volts[{1}], 2.25, 1e-3) << arena;
    EXPECT_EQ(run.motes().volts[{2}], 3) << "it has no battery";
  }
}

TEST(MoteSense, feels_the_turns_of_the_robot_that_carries_it) {
  for (const bool arena : {false, true}) {
    Session run(kBase + ")\nposition( name \"r\" size [0.4 0.4 0.2] alwayson 1 velocity [0.5 0 0 60]\n" +
                    mote("") + ")",
                arena);
    run.step(100);
    EXPECT_NEAR(run.motes().acceleration[{1}].y, 0.5 * geom::kPi / 3, 0.05) << arena;
    EXPECT_NEAR(run.motes().acceleration[{1}].z, run.world().scene().gravity, 0.05) << arena;
  }
}

TEST(MoteSense, feels_no_force_at_constant_speed_however_long_it_has_been_silent) {
  for (const bool arena : {false, true}) {
    Session run("position( name \"r\" size [0.4 0.4 0.2] alwayson 1 velocity [0.5 0 0 0]\n" +
                    mote("alwayson 1 frequency 1") + ")",
                arena);
    run.step(100);
    run.world().motes.awake[{0}] = 0;
    run.step(77);
    run.world().motes.awake[{0}] = 1;
    run.world().motes.frequency[{0}] = 0;
    for (int tick = 0; tick < 3; ++tick) {
      run.step();
      EXPECT_EQ(run.motes().reported_tick[{0}], run.world().tick());
      EXPECT_NEAR(run.motes().acceleration[{0}].x, 0, 1e-3) << arena << ' ' << tick;
    }
  }
}

TEST(MoteSense, feels_a_stop_at_a_wall) {
  for (const bool arena : {false, true}) {
    Session run("position( size [0.4 0.4 0.2] alwayson 1 velocity [0.5 0 0 0]\n" +
                    mote("alwayson 1 frequency 0.5") + ")\nmodel( pose [0.5 0 0 0] size [0.2 2 1] )",
                arena);
    run.step();
    const double v = run.motes().v_WB[{0}].x;
    EXPECT_GT(v, 0.1);
    run.step(150);
    EXPECT_NEAR(run.motes().acceleration[{0}].x, -v / 2, 1e-3) << arena << ": the mean of 2 s";
  }
}

TEST(MoteSense, saturates_at_its_range) {
  Session run(kBase + ")\n" + mote("acceleration_range 5"));
  run.step();
  EXPECT_EQ(run.motes().acceleration[{1}].z, 5);
}

TEST(MoteSense, a_base_station_hears_motes_of_its_group_in_reach_in_the_order_of_ids) {
  Session run(kBase + "group 2 )\n" + mote("group 2 pose [0 9 0 0]") + mote("group 3 pose [0 1 0 0]") +
              mote("group 2 pose [0 11 0 0]") + mote("group 2 base 1 pose [1 0 0 0]") +
              mote("group 2 pose [-3 0 0 0]") + mote("group 2 pose [0 0 10.5 0]"));
  run.step();
  EXPECT_THAT(run.in_reach(), ElementsAre(1, 5));
  EXPECT_EQ(run.heard(), 2);
  EXPECT_NEAR(run.motes().links[{0}][0].level, -senses::path_loss({}, 2450, 9), 1e-9);
}

TEST(MoteSense, hears_nothing_weaker_than_its_sensitivity_and_less_behind_walls) {
  // 40.2 dB at a metre, 20 more at ten.
  const std::string far = mote("pose [4 0 0 0] power -30") + mote("pose [1 1 0 0] power -30");
  Session clear(kBase + "sensitivity -85 )\n" + far);
  clear.step();
  EXPECT_THAT(clear.in_reach(), ElementsAre(1, 2));
  Session weak(kBase + "sensitivity -80 )\n" + far);
  weak.step();
  EXPECT_THAT(weak.in_reach(), ElementsAre(2));
  Session walled(kBase + "sensitivity -85 wall_factor 8 )\n" + far +
                 "model( pose [2 0 0 0] size [0.1 1 2] )");
  walled.step();
  EXPECT_THAT(walled.in_reach(), ElementsAre(2));
  Session carried("model( size [0.4 0.4 1] " + kBase + "sensitivity -85 wall_factor 8 ) )\n" +
                  "model( pose [4 0 0 0] size [0.4 0.4 1] " + mote("power -30") + ")");
  carried.step();
  EXPECT_EQ(carried.in_reach().size(), 1u) << "what carries it is no wall";
}

TEST(MoteSense, reports_as_often_as_it_is_told_to_and_not_while_it_sleeps) {
  Session run(kBase + ")\n" + mote("frequency 10 pose [1 0 0 0]"));
  std::vector<int> heard_in;
  for (int tick = 1; tick <= 12; ++tick) {
    run.step();
    if (run.heard() > 0) heard_in.push_back(tick);
  }
  EXPECT_THAT(heard_in, ElementsAre(1, 6, 11)) << "each fifth tick of 20 ms";
  run.world().motes.awake[{1}] = 0;
  run.step(10);
  EXPECT_EQ(run.motes().reported_tick[{1}], 11u);
  EXPECT_THAT(run.in_reach(), ElementsAre(1)) << "it may be woken";
  run.world().motes.awake[{1}] = 1;
  run.step();
  EXPECT_EQ(run.heard(), 1);
}

TEST(MoteSense, loses_reports_as_often_as_the_world_says) {
  std::string motes;
  for (int k = 0; k < 400; ++k) motes += mote("pose [1 0 0 0]");
  Session half(kBase + "loss 50 )\n" + motes), all(kBase + "loss 100 )\n" + motes);
  half.step(), all.step();
  EXPECT_NEAR(static_cast<double>(half.heard()), 200, 50) << "five standard deviations of 10";
  EXPECT_EQ(all.heard(), 0);
  EXPECT_EQ(all.in_reach().size(), 400u);
}

TEST(MoteSense, measures_nothing_while_nobody_reads) {
  Session run("mote( base 1 )\n" + mote("pose [1 0 0 0]"));
  run.step(3);
  EXPECT_EQ(run.motes().reported_tick[{1}], 0u);
  EXPECT_THAT(run.in_reach(), IsEmpty());
}

TEST(MoteSense, measures_only_where_somebody_reads) {
  Session run(kBase + "group 1 )\n" + mote("group 1 pose [1 0 0 0]") + mote("group 1 pose [20 0 0 0]") +
              mote("pose [1 0 0 0]") + mote("alwayson 1 pose [30 0 0 0]"));
  run.step();
  EXPECT_THAT(run.motes().reported_tick, ElementsAre(1, 1, 0, 0, 1));
}

TEST(MoteSense, a_base_station_knows_its_reach_between_its_updates_and_forgets_it_when_nobody_reads) {
  Session run("mote( base 1 update_interval 100 range 10 )\n" + mote("awake 0 pose [1 0 0 0]") +
              mote("pose [2 0 0 0]"));
  world::subscribe(run.world(), run.world().row(world::ModelId{0}));
  run.step(5);
  EXPECT_THAT(run.in_reach(), ElementsAre(1, 2));
  EXPECT_EQ(run.heard(), 1);
  ASSERT_TRUE(world::set_pose(run.world(), run.world().row(world::ModelId{1}), {20, 0, 0, 0}));
  ASSERT_TRUE(world::set_pose(run.world(), run.world().row(world::ModelId{2}), {20, 0, 0, 0}));
  run.step();
  EXPECT_THAT(run.in_reach(), ElementsAre(1))
      << "the one that reported is gone, the other asleep until the update";
  EXPECT_EQ(run.heard(), 0);
  run.step(4);
  EXPECT_THAT(run.in_reach(), IsEmpty());
  ASSERT_TRUE(world::set_pose(run.world(), run.world().row(world::ModelId{1}), {1, 0, 0, 0}));
  world::unsubscribe(run.world(), run.world().row(world::ModelId{0}));
  run.step();
  EXPECT_EQ(run.motes().measured_tick[{0}], 0u);
  world::subscribe(run.world(), run.world().row(world::ModelId{0}));
  run.step();
  EXPECT_THAT(run.in_reach(), ElementsAre(1)) << "at once";
}

TEST(MoteSense, reports_at_no_rate_that_a_world_file_cannot_have) {
  Session run(mote(""));
  world::Journal journal(run.world());
  for (const double frequency : {1e300, 1.0000001e9, -1.0, -5e-324, HUGE_VAL, std::nan("")})
    EXPECT_FALSE(journal.apply(world::changes::SetReportRate{{0}, frequency})) << frequency;
  for (const double frequency : {1e9, 5e-324, 1e-300, 0.0}) {
    ASSERT_TRUE(journal.apply(world::changes::SetReportRate{{0}, frequency}));
    run.step();
    const Result<std::string> text = scene::write_world(world::as_scene(run.world()), "w.world");
    ASSERT_TRUE(text);
    config::MemoryFiles files({{"w.world", *text}});
    const Result<scene::SceneDesc> again = scene::load_world_text(*text, "w.world", files);
    ASSERT_TRUE(again) << again.error().line();
    EXPECT_EQ(again->models[0].mote->frequency, frequency);
  }
}

TEST(MoteSense, is_the_same_with_any_number_of_workers_and_goes_on_from_a_saved_run) {
  std::string text =
      kBase + "loss 30 )\nmote( base 1 alwayson 1 update_interval 140 range 3 pose [4 0 0 0] )\n";
  for (int k = 0; k < 100; ++k)
    text += "position( size [0.1 0.1 0.1] obstacle_return 0 alwayson 1 velocity [0.5 0 0 30] pose [" +
            std::to_string(k % 10) + " 0 0 0] mote( frequency 7 update_interval 20 ) )\n";
  Session one(text), four(text, false, 4), resumed(text);
  one.step(9), four.step(9);
  std::vector<std::byte> saved;
  ASSERT_TRUE(world::save_state(one.world(), saved));
  ASSERT_TRUE(world::load_state(resumed.world(), saved));
  one.step(9), four.step(9), resumed.step(9);
  EXPECT_EQ(one.world().sensed_hash(), four.world().sensed_hash());
  EXPECT_EQ(one.world().sensed_hash(), resumed.world().sensed_hash());
  EXPECT_EQ(one.heard(), four.heard());
}

}  // namespace
}  // namespace playhouse::arena
