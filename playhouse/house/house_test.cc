// What the simulated house finds, and that it repeats itself. The invariants themselves: playhouse_sim.

#include "playhouse/house/house.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "playhouse/base/log.h"
#include "playhouse/base/testing_folder.h"

namespace playhouse::house {
namespace {

using testing::HasSubstr;

constexpr Setting kAll;  // all but a cluster, in Stage

/// What clients do wrong on purpose is no news.
class House : public testing::Test {
 protected:
  static void SetUpTestSuite() { log::silence(); }
  static Report run(const HouseOptions& options) {
    const TestFolder folder;
    return run_house(options, folder.path().string());
  }
};

TEST_F(House, does_the_same_for_the_same_seed_and_something_else_for_another) {
  const Report first = run({.seed = 7, .seconds = 40, .setting = kAll});
  EXPECT_EQ(first.fault.value_or(""), "");
  EXPECT_GT(first.answers, 100u);
  EXPECT_GT(first.checks, 10u);
  EXPECT_GT(first.frames, 100u);
  EXPECT_EQ(run({.seed = 7, .seconds = 40, .setting = kAll}).digest, first.digest);
  EXPECT_NE(run({.seed = 8, .seconds = 40, .setting = kAll}).digest, first.digest);
}

TEST_F(House, goes_on_after_crashes_and_with_robots_of_other_machines) {
  const Report report = run({.seed = 4, .seconds = 100, .setting = kAll});
  EXPECT_EQ(report.fault.value_or(""), "");
  EXPECT_GT(report.crashes, 1u);
  EXPECT_GT(report.machines, 3u);
  EXPECT_GT(report.checks, 50u);
}

TEST_F(House, is_shared_by_machines_that_come_and_crash) {
  const Setting cluster{.is_cluster = true, .has_pages = false, .has_drivers = false, .crashes = false};
  const Report first = run({.seed = 5, .seconds = 20, .setting = cluster});
  EXPECT_EQ(first.fault.value_or(""), "");
  EXPECT_GT(first.nodes, 2u);
  EXPECT_EQ(run({.seed = 5, .seconds = 20, .setting = cluster}).digest, first.digest);
}

TEST_F(House, finds_an_answer_that_was_lost) {
  const Report report = run({.seed = 1, .seconds = 100, .sabotage = Sabotage::kLosesAnswer, .setting = kAll});
  EXPECT_THAT(report.fault.value_or(""), HasSubstr("requests of a client are not answered"));
}

TEST_F(House, finds_data_of_a_tick_that_were_lost) {
  const Report report = run({.seed = 1, .seconds = 100, .sabotage = Sabotage::kLosesTick, .setting = kAll});
  EXPECT_THAT(report.fault.value_or(""), HasSubstr("a client gets data of interface "));
}

TEST_F(House, finds_changes_that_a_page_did_not_get) {
  const Report report = run({.seed = 1, .seconds = 100, .sabotage = Sabotage::kLosesFrame, .setting = kAll});
  EXPECT_THAT(report.fault.value_or(""), HasSubstr("a page holds a world that tick "));
}

TEST_F(House, finds_a_change_that_is_missing_in_the_recording) {
  const Report report = run({.seed = 1, .seconds = 50, .sabotage = Sabotage::kLosesChange, .setting = kAll});
  EXPECT_THAT(report.fault.value_or(""), HasSubstr("run again, at "));
}

}  // namespace
}  // namespace playhouse::house
