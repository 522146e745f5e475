#include "playhouse/drivers/simulated/pacer.h"

#include <gtest/gtest.h>

namespace playhouse::drivers {
namespace {

TEST(Pacer, the_first_tick_is_due_at_once_and_the_next_an_interval_later) {
  Pacer pacer(0.1);
  pacer.restart(5.0, 1);
  EXPECT_DOUBLE_EQ(*pacer.due(), 5.0);
  pacer.ticked(5.01);
  EXPECT_DOUBLE_EQ(*pacer.due(), 5.1) << "a late tick must not delay the ones after it";
}

TEST(Pacer, twice_the_speed_halves_the_time_between_ticks) {
  Pacer pacer(0.1);
  pacer.restart(0, 2);
  pacer.ticked(0);
  EXPECT_DOUBLE_EQ(*pacer.due(), 0.05);
}

TEST(Pacer, as_fast_as_possible_is_always_due) {
  Pacer pacer(0.1);
  pacer.restart(0, 0);
  EXPECT_FALSE(pacer.due().has_value());
}

TEST(Pacer, gives_up_the_time_a_stalled_run_lost) {
  Pacer pacer(0.1);
  pacer.restart(0, 1);
  pacer.ticked(10);
  EXPECT_DOUBLE_EQ(*pacer.due(), 10);
}

TEST(Pacer, catches_up_after_a_short_delay) {
  Pacer pacer(0.1);
  pacer.restart(0, 1);
  pacer.ticked(0.2);
  EXPECT_DOUBLE_EQ(*pacer.due(), 0.1);
}

TEST(Pacer, measures_the_real_time_factor_over_a_second) {
  Pacer pacer(0.1);
  pacer.restart(0, 0);
  for (int i = 1; i <= 40; ++i) pacer.ticked(i * 0.025);
  EXPECT_NEAR(pacer.real_time_factor(), 4.0, 1e-9);
}

}  // namespace
}  // namespace playhouse::drivers
