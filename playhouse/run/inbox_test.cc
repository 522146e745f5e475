#include "playhouse/run/inbox.h"

#include <gtest/gtest.h>

#include "playhouse/base/limits.h"

namespace playhouse::run {
namespace {

constexpr world::ModelId kFirst{0}, kSecond{1};

/// An inbox whose commands say their numbers when they are carried out, and changes 0.
struct Listening {
  Inbox inbox;
  std::vector<int> said = {};

  void command(world::ModelId model, int number) {
    inbox.command(world::changes::SetFiducial{model, number});
  }
  Request change() {
    return [this](const world::Journal&) { said.push_back(0); };
  }
  /// Numbers of what is taken now, in order.
  std::vector<int> take() {
    std::vector<Inbox::InboxEntry> taken;
    inbox.take(taken);
    const scene::SceneDesc scene;
    world::World world(scene, 1);
    world::Journal journal(world);
    said.clear();
    for (const Inbox::InboxEntry& each : taken) {
      const auto* const command = std::get_if<world::Change>(&each);
      command ? said.push_back(std::get<world::changes::SetFiducial>(*command).id)
              : std::get<Request>(each)(journal);
    }
    return said;
  }
};

TEST(Inbox, a_newer_command_replaces_the_one_that_waits) {
  Listening in;
  in.command(kFirst, 1);
  in.command(kSecond, 2);
  in.command(kFirst, 3);
  EXPECT_EQ(in.take(), (std::vector{3, 2}));
}

TEST(Inbox, a_command_before_a_close_is_carried_out_before_it_and_one_after_it_after_it) {
  Listening in;
  in.command(kFirst, 1);
  in.command(kSecond, 2);
  in.inbox.post_always(in.change(), kFirst);
  in.command(kFirst, 3);
  in.command(kSecond, 4);
  EXPECT_EQ(in.take(), (std::vector{1, 4, 0, 3}));
}

TEST(Inbox, a_change_of_another_robot_does_not_hold_a_command_up) {
  Listening in;
  in.command(kFirst, 1);
  ASSERT_TRUE(in.inbox.post(in.change(), kSecond));
  in.command(kFirst, 2);
  EXPECT_EQ(in.take(), (std::vector{2, 0}));
}

TEST(Inbox, a_change_of_all_robots_keeps_its_place_among_the_commands_of_each) {
  Listening in;
  in.command(kFirst, 1);
  ASSERT_TRUE(in.inbox.post_to_all(in.change()));
  in.command(kFirst, 2);
  in.command(kSecond, 3);
  EXPECT_EQ(in.take(), (std::vector{1, 0, 2, 3}));
}

TEST(Inbox, what_was_taken_is_not_replaced_any_more) {
  Listening in;
  in.command(kFirst, 1);
  EXPECT_EQ(in.take(), std::vector{1});
  in.command(kFirst, 2);
  EXPECT_EQ(in.take(), std::vector{2});
}

TEST(Inbox, refuses_changes_when_the_queue_is_full_but_takes_commands_and_closes) {
  Listening in;
  for (std::size_t i = 0; i < limits::kRequestQueue; ++i) ASSERT_TRUE(in.inbox.post(in.change()));
  EXPECT_FALSE(in.inbox.post(in.change()));
  in.command(kFirst, 1);
  in.inbox.post_always(in.change(), kFirst);
  EXPECT_EQ(in.take().size(), limits::kRequestQueue + 2);
  EXPECT_TRUE(in.inbox.post(in.change())) << "taking must make room again";
}

}  // namespace
}  // namespace playhouse::run
