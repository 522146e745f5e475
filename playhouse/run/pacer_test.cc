#include "playhouse/run/pacer.h"

#include <gtest/gtest.h>

namespace playhouse::run {
namespace {

TEST(Pacer, the_first_tick_is_due_at_once_and_the_next_an_interval_later) {
  Pacer pacer(0.1);
  pacer.start(5.0, 1, false);
  EXPECT_DOUBLE_EQ(*pacer.due(), 5.0);
  pacer.ticked(5.01);
  EXPECT_DOUBLE_EQ(*pacer.due(), 5.1) << "a late tick must not delay the ones after it";
}

TEST(Pacer, twice_the_speed_halves_the_time_between_ticks) {
  Pacer pacer(0.1);
  pacer.start(0, 2, false);
  pacer.ticked(0);
  EXPECT_DOUBLE_EQ(*pacer.due(), 0.05);
}

TEST(Pacer, as_fast_as_possible_is_always_due) {
  Pacer pacer(0.1);
  pacer.start(0, 0, false);
  EXPECT_FALSE(pacer.due().has_value());
}

TEST(Pacer, gives_up_the_time_a_stalled_run_lost) {
  Pacer pacer(0.1);
  pacer.start(0, 1, false);
  pacer.ticked(10);
  EXPECT_DOUBLE_EQ(*pacer.due(), 10);
}

TEST(Pacer, catches_up_after_a_short_delay) {
  Pacer pacer(0.1);
  pacer.start(0, 1, false);
  pacer.ticked(0.2);
  EXPECT_DOUBLE_EQ(*pacer.due(), 0.1);
}

TEST(Pacer, another_speed_changes_how_fast_what_is_left_of_the_interval_goes_by) {
  Pacer pacer(0.1);
  pacer.start(0, 1, false);
  pacer.ticked(0);
  pacer.change(0.06, 4, false);
  EXPECT_DOUBLE_EQ(*pacer.due(), 0.07);
  pacer.change(0.07, 1, false);
  EXPECT_DOUBLE_EQ(*pacer.due(), 0.07) << "it stays due";
}

TEST(Pacer, a_pause_keeps_what_is_left_of_the_interval) {
  Pacer pacer(0.1);
  pacer.start(0, 1, false);
  pacer.ticked(0);
  pacer.change(0.06, 1, true);
  pacer.change(5.06, 1, false);
  EXPECT_DOUBLE_EQ(*pacer.due(), 5.1);
}

TEST(Pacer, a_single_step_has_the_whole_interval_ahead) {
  Pacer pacer(0.1);
  pacer.start(0, 1, true);
  pacer.ticked(1);
  pacer.change(2, 1, false);
  EXPECT_DOUBLE_EQ(*pacer.due(), 2.1);
}

TEST(Pacer, after_as_fast_as_possible_a_whole_interval_passes) {
  Pacer pacer(0.1);
  pacer.start(0, 0, false);
  pacer.ticked(1);
  pacer.change(1, 1, false);
  EXPECT_DOUBLE_EQ(*pacer.due(), 1.1);
}

TEST(Pacer, a_speed_near_zero_is_left_as_any_other) {
  Pacer pacer(0.1);
  pacer.start(0, 1, false);
  pacer.ticked(0);
  pacer.change(0.06, 5e-324, false);
  EXPECT_GT(*pacer.due(), 1e300);
  pacer.change(1, 1, false);
  EXPECT_LE(*pacer.due(), 1.1);
}

TEST(Pacer, measures_the_real_time_factor_over_a_second) {
  Pacer pacer(0.1);
  pacer.start(0, 0, false);
  for (int i = 1; i <= 40; ++i) pacer.ticked(i * 0.025);
  EXPECT_NEAR(pacer.real_time_factor(), 4.0, 1e-9);
}

}  // namespace
}  // namespace playhouse::run
