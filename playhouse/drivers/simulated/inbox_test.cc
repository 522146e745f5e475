#include "playhouse/drivers/simulated/inbox.h"

#include <gtest/gtest.h>

#include "playhouse/base/limits.h"

namespace playhouse::drivers {
namespace {

constexpr world::ModelId kFirst{0}, kSecond{1};

PositionCommand forward(world::ModelId robot, double speed) {
  return {.robot = robot, .value = {speed, 0, 0}};
}

double speed_of(const Inbox::Entry& entry) {
  return std::get<PositionCommand>(entry).value[0];
}

void nothing(world::World&) {}

TEST(Inbox, a_newer_command_replaces_the_one_that_waits) {
  Inbox inbox;
  std::vector<Inbox::Entry> taken;
  inbox.command(forward(kFirst, 1));
  inbox.command(forward(kSecond, 2));
  inbox.command(forward(kFirst, 3));
  inbox.take(taken);
  ASSERT_EQ(taken.size(), 2u);
  EXPECT_EQ(speed_of(taken[0]), 3);
  EXPECT_EQ(speed_of(taken[1]), 2);
}

TEST(Inbox, a_command_before_a_close_is_carried_out_before_it_and_one_after_it_after_it) {
  Inbox inbox;
  std::vector<Inbox::Entry> taken;
  inbox.command(forward(kFirst, 1));
  inbox.post_always(nothing, kFirst);
  inbox.command(forward(kFirst, 2));
  inbox.take(taken);
  ASSERT_EQ(taken.size(), 3u);
  EXPECT_EQ(speed_of(taken[0]), 1);
  EXPECT_TRUE(std::holds_alternative<Change>(taken[1]));
  EXPECT_EQ(speed_of(taken[2]), 2);
}

TEST(Inbox, a_change_of_another_robot_does_not_hold_a_command_up) {
  Inbox inbox;
  std::vector<Inbox::Entry> taken;
  inbox.command(forward(kFirst, 1));
  ASSERT_TRUE(inbox.post(nothing, kSecond));
  inbox.command(forward(kFirst, 2));
  inbox.take(taken);
  ASSERT_EQ(taken.size(), 2u);
  EXPECT_EQ(speed_of(taken[0]), 2);
}

TEST(Inbox, a_change_of_all_robots_keeps_its_place_among_the_commands_of_each) {
  Inbox inbox;
  std::vector<Inbox::Entry> taken;
  inbox.command(forward(kFirst, 1));
  ASSERT_TRUE(inbox.post_to_all(nothing));
  inbox.command(forward(kFirst, 2));
  inbox.command(forward(kSecond, 3));
  inbox.take(taken);
  ASSERT_EQ(taken.size(), 4u);
  EXPECT_EQ(speed_of(taken[0]), 1);
  EXPECT_EQ(speed_of(taken[2]), 2);
  EXPECT_EQ(speed_of(taken[3]), 3);
}

TEST(Inbox, what_was_taken_is_not_replaced_any_more) {
  Inbox inbox;
  std::vector<Inbox::Entry> taken, later;
  inbox.command(forward(kFirst, 1));
  inbox.take(taken);
  inbox.command(forward(kFirst, 2));
  inbox.take(later);
  ASSERT_EQ(later.size(), 1u);
  EXPECT_EQ(speed_of(taken[0]), 1);
  EXPECT_EQ(speed_of(later[0]), 2);
}

TEST(Inbox, refuses_changes_when_the_queue_is_full_but_takes_commands_and_closes) {
  Inbox inbox;
  for (std::size_t i = 0; i < limits::kRequestQueue; ++i) ASSERT_TRUE(inbox.post(nothing));
  EXPECT_FALSE(inbox.post(nothing));
  inbox.command(forward(kFirst, 1));
  inbox.post_always(nothing, kFirst);
  std::vector<Inbox::Entry> taken;
  inbox.take(taken);
  EXPECT_EQ(taken.size(), limits::kRequestQueue + 2);
  EXPECT_TRUE(inbox.post(nothing)) << "taking must make room again";
}

}  // namespace
}  // namespace playhouse::drivers
