#include "playhouse/drivers/simulated/mailbox.h"

#include <gtest/gtest.h>

#include "playhouse/base/limits.h"

namespace playhouse::drivers {
namespace {

constexpr world::PositionRow kFirst{0}, kSecond{1};

PositionCommand forward(world::PositionRow robot, double speed) {
  return {.robot = robot, .value = {speed, 0, 0}};
}

double speed_of(const Mailbox::Entry& entry) {
  return std::get<PositionCommand>(entry).value[0];
}

void nothing(world::World&) {}

TEST(Mailbox, a_newer_command_replaces_the_one_that_waits) {
  Mailbox mailbox(2);
  std::vector<Mailbox::Entry> taken;
  mailbox.command(forward(kFirst, 1));
  mailbox.command(forward(kSecond, 2));
  mailbox.command(forward(kFirst, 3));
  mailbox.take(taken);
  ASSERT_EQ(taken.size(), 2u);
  EXPECT_EQ(speed_of(taken[0]), 3);
  EXPECT_EQ(speed_of(taken[1]), 2);
}

TEST(Mailbox, a_command_before_a_close_is_carried_out_before_it_and_one_after_it_after_it) {
  Mailbox mailbox(1);
  std::vector<Mailbox::Entry> taken;
  mailbox.command(forward(kFirst, 1));
  mailbox.post_always(nothing, kFirst);
  mailbox.command(forward(kFirst, 2));
  mailbox.take(taken);
  ASSERT_EQ(taken.size(), 3u);
  EXPECT_EQ(speed_of(taken[0]), 1);
  EXPECT_TRUE(std::holds_alternative<Change>(taken[1]));
  EXPECT_EQ(speed_of(taken[2]), 2);
}

TEST(Mailbox, a_change_of_another_robot_does_not_hold_a_command_up) {
  Mailbox mailbox(2);
  std::vector<Mailbox::Entry> taken;
  mailbox.command(forward(kFirst, 1));
  ASSERT_TRUE(mailbox.post(nothing, kSecond));
  mailbox.command(forward(kFirst, 2));
  mailbox.take(taken);
  ASSERT_EQ(taken.size(), 2u);
  EXPECT_EQ(speed_of(taken[0]), 2);
}

TEST(Mailbox, what_was_taken_is_not_replaced_any_more) {
  Mailbox mailbox(1);
  std::vector<Mailbox::Entry> taken, later;
  mailbox.command(forward(kFirst, 1));
  mailbox.take(taken);
  mailbox.command(forward(kFirst, 2));
  mailbox.take(later);
  ASSERT_EQ(later.size(), 1u);
  EXPECT_EQ(speed_of(taken[0]), 1);
  EXPECT_EQ(speed_of(later[0]), 2);
}

TEST(Mailbox, refuses_changes_when_the_queue_is_full_but_takes_commands_and_closes) {
  Mailbox mailbox(1);
  for (std::size_t i = 0; i < limits::kRequestQueue; ++i) ASSERT_TRUE(mailbox.post(nothing));
  EXPECT_FALSE(mailbox.post(nothing));
  mailbox.command(forward(kFirst, 1));
  mailbox.post_always(nothing, kFirst);
  std::vector<Mailbox::Entry> taken;
  mailbox.take(taken);
  EXPECT_EQ(taken.size(), limits::kRequestQueue + 2);
  EXPECT_TRUE(mailbox.post(nothing)) << "taking must make room again";
}

}  // namespace
}  // namespace playhouse::drivers
