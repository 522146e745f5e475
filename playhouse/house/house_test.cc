// What the simulated house finds, and that it repeats itself. The invariants themselves: playhouse_sim.

#include "playhouse/house/house.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "playhouse/base/log.h"
#include "playhouse/base/testing_folder.h"

namespace playhouse::house {
namespace {

using testing::HasSubstr;

/// What clients do wrong on purpose is no news.
class House : public testing::Test {
 protected:
  static void SetUpTestSuite() { log::silence(); }
  static Report run(const Options& options) {
    const TestFolder folder;
    return run_house(options, folder.path().string());
  }
};

TEST_F(House, does_the_same_for_the_same_seed_and_something_else_for_another) {
  const Report first = run({.seed = 7, .seconds = 40});
  EXPECT_EQ(first.fault.value_or(""), "");
  EXPECT_GT(first.answers, 100u);
  EXPECT_GT(first.checks, 10u);
  EXPECT_GT(first.frames, 100u);
  EXPECT_EQ(run({.seed = 7, .seconds = 40}).digest, first.digest);
  EXPECT_NE(run({.seed = 8, .seconds = 40}).digest, first.digest);
}

TEST_F(House, finds_an_answer_that_was_lost) {
  const Report report = run({.seed = 1, .seconds = 100, .sabotage = Sabotage::kLosesAnswer});
  EXPECT_THAT(report.fault.value_or(""), HasSubstr("requests of a client are not answered"));
}

TEST_F(House, finds_data_of_a_tick_that_were_lost) {
  const Report report = run({.seed = 1, .seconds = 100, .sabotage = Sabotage::kLosesTick});
  EXPECT_THAT(report.fault.value_or(""), HasSubstr("a client gets data of interface "));
}

TEST_F(House, finds_changes_that_a_page_did_not_get) {
  const Report report = run({.seed = 1, .seconds = 100, .sabotage = Sabotage::kLosesFrame});
  EXPECT_THAT(report.fault.value_or(""), HasSubstr("a page holds a world that tick "));
}

TEST_F(House, finds_a_change_that_is_missing_in_the_recording) {
  const Report report = run({.seed = 1, .seconds = 50, .sabotage = Sabotage::kLosesChange});
  EXPECT_THAT(report.fault.value_or(""), HasSubstr("run again, at "));
}

}  // namespace
}  // namespace playhouse::house
