// Which radios receive what a radio sends, in which order, and that a run with messages is the same run.

#include <gtest/gtest.h>

#include <string>
#include <string_view>
#include <vector>

#include "playhouse/base/limits.h"
#include "playhouse/scene/world_loader.h"
#include "playhouse/stage/engine.h"
#include "playhouse/world/radio_messages.h"
#include "playhouse/world/saving/state.h"

namespace playhouse::senses {
namespace {

/// Four radios a metre from each other that hear 1.5 m far; the last is of another network.
constexpr const char* kRow = R"(
define radio wifi( model "simple" range 1.5 alwayson 1 )
radio( name "a" pose [0 0 0 0] )
radio( name "b" pose [1 0 0 0] )
radio( name "c" pose [2 0 0 0] )
radio( name "far" pose [0 1 0 0] essid "another" )
)";

class RadioMessages : public ::testing::Test {
 protected:
  void load(const std::string& text, unsigned workers = 1, std::uint64_t seed = 1) {
    config::MemoryFiles none({});
    auto scene = scene::load_world_text(text, "test.world", none);
    ASSERT_TRUE(scene) << scene.error().line();
    engine_.reset();
    scene_ = std::make_unique<scene::SceneDesc>(std::move(*scene));
    engine_ = *stage::make_engine(*scene_, {.seed = seed, .workers = workers});
  }
  world::World& world() { return engine_->world(); }
  world::WifiRow radio(std::string_view name) { return world().models.part[world().find(name)]; }
  bool send(std::string_view from, std::string_view text, std::string_view to = "") {
    const world::ModelId id = to.empty() ? world::ModelId{} : world().id(world().find(to));
    const std::vector<std::uint8_t> bytes(text.begin(), text.end());
    return world::send_message(world(), radio(from), id, bytes);
  }
  void step() { engine_->step(); }
  /// What arrived in the last tick: "a:hello b:hi ".
  std::string received(std::string_view name) {
    std::string all;
    world::each_message(world::incoming_of(world().wifis, radio(name)), [&](const auto& message, auto bytes) {
      all += world().name(world().row(message.station)) + ":" + std::string(bytes.begin(), bytes.end()) + " ";
    });
    return all;
  }

  std::unique_ptr<scene::SceneDesc> scene_;
  std::unique_ptr<world::Engine> engine_;
};

TEST_F(RadioMessages, a_message_reaches_all_who_hear_the_sender_in_the_next_tick_and_only_then) {
  load(kRow);
  ASSERT_TRUE(send("a", "hello"));
  EXPECT_EQ(received("b"), "") << "before the tick";
  step();
  EXPECT_EQ(received("b"), "a:hello ");
  EXPECT_EQ(received("c"), "") << "out of range";
  EXPECT_EQ(received("far"), "") << "another network";
  EXPECT_EQ(received("a"), "") << "its own";
  step();
  EXPECT_EQ(received("b"), "");
}

TEST_F(RadioMessages, a_message_to_one_reaches_that_one_alone_and_only_if_it_hears) {
  load(kRow);
  send("b", "to a", "a");
  send("a", "to c", "c");
  step();
  EXPECT_EQ(received("a"), "b:to a ");
  EXPECT_EQ(received("b"), "");
  EXPECT_EQ(received("c"), "") << "it is too far from a";
}

TEST_F(RadioMessages, messages_arrive_in_the_order_of_senders_and_then_as_they_were_sent) {
  load(kRow);
  send("c", "1");
  send("a", "2");
  send("c", "");
  send("a", "3");
  step();
  EXPECT_EQ(received("b"), "a:2 a:3 c:1 c: ");
}

TEST_F(RadioMessages, arrive_in_each_tick_however_seldom_the_radio_listens_for_others) {
  load(std::string(kRow) + "interval_sim 100\nradio( name \"slow\" pose [0 -1 0 0] update_interval 1000 )");
  step();
  const std::uint64_t measured = world().wifis.measured_tick[radio("slow")];
  send("a", "now");
  step();
  EXPECT_EQ(world().wifis.measured_tick[radio("slow")], measured);
  EXPECT_EQ(received("slow"), "a:now ");
}

TEST_F(RadioMessages, do_not_reach_radios_that_nobody_has_open) {
  load(std::string(kRow) + "wifi( name \"idle\" pose [0 -1 0 0] )");
  send("a", "hello");
  step();
  EXPECT_EQ(received("idle"), "");
}

TEST_F(RadioMessages, walls_are_in_the_way_as_of_links) {
  const std::string wall = "model( name \"wall\" pose [1 0 0 0] size [0.2 10 1] )";
  const std::string radios =
      "wifi( name \"a\" pose [0 0 0.5 0] power 0 alwayson 1 )\n"
      "wifi( name \"b\" pose [2 0 0.5 0] alwayson 1 model \"raytrace\" wall_factor 60 )\n";
  for (const bool between : {false, true}) {
    load(radios + (between ? wall : ""));
    send("a", "hello");
    step();
    EXPECT_EQ(received("b"), between ? "" : "a:hello ");
    EXPECT_EQ(world().wifis.links[radio("b")].size(), between ? 0u : 1u);
  }
}

TEST_F(RadioMessages, are_lost_as_often_as_the_receiver_says) {
  load(
      "wifi( name \"a\" alwayson 1 )\nwifi( name \"b\" pose [1 0 0 0] loss 30 alwayson 1 )\n"
      "wifi( name \"deaf\" pose [0 1 0 0] loss 100 alwayson 1 )");
  int arrived = 0;
  for (int tick = 0; tick < 200; ++tick) {
    for (int i = 0; i < 10; ++i) send("a", "x");
    step();
    arrived += static_cast<int>(world().wifis.incoming[radio("b")].size());
    EXPECT_EQ(received("deaf"), "");
  }
  EXPECT_NEAR(arrived / 2000.0, 0.7, 0.04);
}

TEST_F(RadioMessages, more_than_there_is_room_for_are_dropped_and_counted) {
  load(kRow);
  for (std::size_t i = 0; i < limits::kRadioSends; ++i) ASSERT_TRUE(send("a", "x"));
  EXPECT_FALSE(send("a", "x"));
  EXPECT_EQ(world().wifis.dropped[radio("a")], 1u);
  EXPECT_FALSE(send("b", std::string(limits::kRadioMessageBytes + 1, 'x')));
  EXPECT_TRUE(send("b", std::string(limits::kRadioMessageBytes, 'x')));
  step();
  EXPECT_EQ(world().wifis.incoming[radio("b")].size(), limits::kRadioSends);
  EXPECT_TRUE(send("a", "y")) << "there is room again";
}

TEST_F(RadioMessages, a_receiver_among_too_many_senders_drops_the_rest) {
  std::string text = "wifi( name \"hub\" alwayson 1 )\n";
  for (int i = 0; i < 5; ++i) text += "wifi( name \"s" + std::to_string(i) + "\" pose [1 0 0 0] )\n";
  load(text);
  for (int i = 0; i < 5; ++i)
    for (std::size_t n = 0; n < limits::kRadioSends; ++n) send("s" + std::to_string(i), "x");
  step();
  EXPECT_EQ(world().wifis.incoming[radio("hub")].size(), limits::kRadioReceives);
  EXPECT_EQ(world().wifis.dropped[radio("hub")], 5 * limits::kRadioSends - limits::kRadioReceives);
}

TEST_F(RadioMessages, a_run_with_messages_is_the_same_for_any_number_of_workers) {
  std::string text;
  for (int i = 0; i < 100; ++i)
    text += "wifi( name \"r" + std::to_string(i) + "\" pose [" + std::to_string(i % 10 * 20) + " " +
            std::to_string(i / 10 * 20) + " 0 0] alwayson 1 fading 3 loss 20 power 0 )\n";
  std::vector<std::uint64_t> hashes, sensed;
  for (const unsigned workers : {1u, 2u, 3u}) {
    load(text, workers);
    std::size_t arrived = 0;
    for (int tick = 0; tick < 5; ++tick) {
      for (int i = 0; i < 100; i += 3) send("r" + std::to_string(i), "from " + std::to_string(i));
      step();
      for (const auto& each : world().wifis.incoming) arrived += each.size();
    }
    EXPECT_GT(arrived, 100u);
    hashes.push_back(world().hash());
    sensed.push_back(world().sensed_hash());
  }
  EXPECT_EQ(hashes, std::vector(3, hashes[0]));
  EXPECT_EQ(sensed, std::vector(3, sensed[0]));
}

TEST_F(RadioMessages, what_waits_to_be_sent_is_part_of_the_state_and_arrives_after_it_is_loaded) {
  load(kRow);
  step();
  const std::uint64_t silent = world().hash();
  send("a", "in flight", "b");
  send("a", "too");
  EXPECT_NE(world().hash(), silent);
  std::vector<std::byte> state;
  ASSERT_TRUE(world::save_state(world(), state));
  const std::uint64_t saved = world().hash();
  load(kRow);
  const auto loaded = world::load_state(world(), state);
  ASSERT_TRUE(loaded) << loaded.error().line();
  EXPECT_EQ(world().hash(), saved);
  step();
  EXPECT_EQ(received("b"), "a:in flight a:too ");
}

TEST_F(RadioMessages, a_state_whose_messages_are_not_whole_is_refused) {
  load(kRow);
  send("a", "hello");
  world().wifis.outgoing_bytes[{0}].pop_back();
  std::vector<std::byte> state;
  ASSERT_TRUE(world::save_state(world(), state));
  load(kRow);
  const auto loaded = world::load_state(world(), state);
  ASSERT_FALSE(loaded);
  EXPECT_NE(loaded.error().text.find("a message of a radio is not whole"), std::string::npos);
}

TEST_F(RadioMessages, the_return_to_the_start_sends_nothing_that_waits) {
  load(kRow);
  send("a", "hello");
  world::return_to_start(world());
  step();
  EXPECT_EQ(received("b"), "");
}

}  // namespace
}  // namespace playhouse::senses
