#include "playhouse/replicate/datagrams/datagram.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "playhouse/replicate/datagrams/datagram_link.h"
#include "playhouse/replicate/importance.h"
#include "playhouse/world/population/population.h"
#include "playhouse/world/saving/state.h"

namespace playhouse::replicate {
namespace {

/// What the observer must hold in the end: the oracle.
void expect_same(const Snapshot& snapshot, const ObservedWorld& world) {
  const Layout& layout = *snapshot.layout;
  ASSERT_EQ(world.models().size(), layout.id.size());
  std::map<std::uint32_t, std::string> says;
  for (const Said& said : snapshot.says) says[layout.id[said.model].value] = said.text;
  for (const world::ModelRow row : layout.id.rows()) {
    const auto held = world.models().find(layout.id[row].value);
    ASSERT_NE(held, world.models().end()) << row.index;
    EXPECT_EQ(held->second.state, snapshot.models[row]) << row.index;
    EXPECT_EQ(held->second.says, says[layout.id[row].value]);
    const bool is_top = !layout.parent[row];
    EXPECT_EQ(held->second.parent.has_value(), !is_top);
    if (!is_top) EXPECT_EQ(*held->second.parent, layout.id[layout.parent[row]].value);
  }
}

/// Somebody comes, goes, is taken along, or says something.
void change(SmallWorld& small, Rng& rng) {
  world::World& world = small.world;
  const auto any = [&] { return world.models.id[world.models.id.rows()[rng.bits() % world.models.size()]]; };
  switch (rng.bits() % 5) {
    case 0:
      static_cast<void>(world::spawn(world, SmallWorld::robot(0), {1, 2, 0, 3}));
      return;
    case 1:
      static_cast<void>(world::spawn(world, small.puck(), {1, 2, 0, 3}));
      return;
    case 2:
      if (world.models.size() > 1) static_cast<void>(world::despawn(world, any()));
      return;
    case 3:
      static_cast<void>(world::attach(world, any(), any(), {0.2, 0, 0, 0}));
      return;
    default:
      world::set_say(world, world.row(any()), std::string(rng.bits() % 40, 'a'));
  }
}

class OverABadNetwork : public testing::TestWithParam<LinkFaults> {};

TEST_P(OverABadNetwork, the_observer_holds_the_world_once_that_stands) {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    SmallWorld small(30, 2);
    DatagramLink link(small, GetParam(), seed);
    Rng rng(seed + 100);
    for (int round = 0; round < 4; ++round) {
      for (int ticks = 0; ticks < 60; ++ticks) {
        small.tick();
        if (ticks % 10 == 0) change(small, rng);
        link.frame();
        ASSERT_FALSE(link.observer.ended()) << *link.observer.ended();
      }
      ASSERT_TRUE(link.settle(3000)) << "seed " << seed << " round " << round;
      expect_same(link.snapshot, link.observer.world());
    }
  }
}

INSTANTIATE_TEST_SUITE_P(
    Losses, OverABadNetwork,
    testing::Values(LinkFaults{}, LinkFaults{.loss = 0.1}, LinkFaults{.loss = 0.3}, LinkFaults{.loss = 0.5},
                    LinkFaults{.duplication = 0.5}, LinkFaults{.jitter = 0.3},
                    LinkFaults{.loss = 0.3, .duplication = 0.3, .delay = 0.1, .jitter = 0.2},
                    LinkFaults{.delay = 0.5}),
    [](const auto& each) {
      const LinkFaults& faults = each.param;
      return "loss" + std::to_string(static_cast<int>(100 * faults.loss)) + "double" +
             std::to_string(static_cast<int>(100 * faults.duplication)) + "delay" +
             std::to_string(static_cast<int>(1000 * faults.delay)) + "jitter" +
             std::to_string(static_cast<int>(1000 * faults.jitter));
    });

TEST(DatagramViewer, a_late_joiner_gets_the_whole_world_at_once) {
  SmallWorld small(300);
  for (int k = 0; k < 300; ++k) world::set_pose(small.world, {SmallWorld::robot(k)}, {k * 1.0, 2, 0, 1});
  world::set_say(small.world, {SmallWorld::robot(7)}, "hello");
  DatagramLink link(small, {}, 1);
  for (int k = 0; k < 300; ++k) world::set_pose(small.world, {SmallWorld::robot(k)}, {k * 1.0, 3, 0, 1});
  EXPECT_TRUE(link.settle(60));  // two seconds
  expect_same(link.snapshot, link.observer.world());
  EXPECT_EQ(link.observer.world().name(), "small");
}

TEST(DatagramViewer, tells_when_the_observer_knows_where_all_are_and_not_before) {
  for (const double loss : {0.0, 0.4}) {
    SmallWorld small(300);
    LinkFaults faults;
    faults.loss = loss;
    DatagramLink link(small, faults, 3);
    for (int k = 0; k < 200; ++k) world::set_pose(small.world, {SmallWorld::robot(k)}, {k * 1.0, 3, 0, 1});
    bool was_told_of = false;
    for (int frames = 0; frames < 200 && !link.observer.world().is_whole(); ++frames) {
      was_told_of = was_told_of || link.observer.world().has_scene();
      link.frame();
    }
    ASSERT_TRUE(link.observer.world().is_whole()) << loss;
    EXPECT_TRUE(was_told_of) << "the scene comes first";
    expect_same(link.snapshot, link.observer.world());
  }
}

TEST(DatagramViewer, is_whole_while_models_are_spawned_more_often_than_a_round_trip) {
  SmallWorld small(30);
  DatagramLink link(small, {.delay = 0.1}, 3);
  for (int k = 0; k < 20; ++k) world::set_pose(small.world, {SmallWorld::robot(k)}, {k * 1.0, 3, 0, 1});
  for (int frames = 0; frames < 60 && !link.observer.world().is_whole(); ++frames) {
    ASSERT_TRUE(world::spawn(small.world, SmallWorld::robot(0), {frames * 1.0, 7, 0, 0}));
    link.frame();
  }
  EXPECT_TRUE(link.observer.world().is_whole());
}

TEST(DatagramViewer, never_sends_more_than_its_budget_nor_longer_than_a_datagram) {
  for (const double loss : {0.0, 0.5}) {
    SmallWorld small(400);
    const Terms terms{20000, 30};
    DatagramLink link(small, {.loss = loss}, 3, terms);
    std::vector<std::pair<double, std::size_t>> sent;
    link.on_sent = [&](std::span<const std::byte> datagram) {
      sent.emplace_back(link.time, datagram.size() + limits::kDatagramHeadBytes);
    };
    for (int ticks = 0; ticks < 300; ++ticks) {
      small.tick();
      link.frame();
    }
    EXPECT_LE(link.longest, limits::kDatagramBytes);
    // And it is used, once the scene is there.
    double late = 0;
    for (const auto& [time, bytes] : sent) late += time > link.time - 3 ? static_cast<double>(bytes) : 0;
    EXPECT_GT(late, 0.9 * 20000 * 3);
    // In any second, however it is cut out.
    for (std::size_t first = 0, last = 0, sum = 0; last < sent.size(); ++last) {
      sum += sent[last].second;
      for (; sent[last].first - sent[first].first >= 1; ++first) sum -= sent[first].second;
      ASSERT_LE(sum, 20000u + 2000u);
    }
  }
}

/// Bodies that drive at 1 m/s in circles, each its own, 30 frames a second.
struct Driven {
  double bytes_per_second = 0, rows_per_frame = 0;
  std::uint64_t oldest = 0;  // ticks, of the state of any
};
Driven drive_in_circles(int robots, Terms terms, LinkFaults faults) {
  SmallWorld small(robots);
  DatagramLink link(small, faults, 9, terms);
  EXPECT_TRUE(link.settle(1000));
  Driven driven;
  std::size_t before = 0;
  double since = 0;
  for (int step = 0; step < 330; ++step) {
    for (int k = 0; k < robots; ++k) {
      const double turn = 0.01 * (k % 7 + 1) * step + k;
      const double radius = 1 / (0.3 * (k % 7 + 1));
      world::set_pose(small.world, {SmallWorld::robot(k)},
                      {k % 20 + radius * std::cos(turn), k / 20 + radius * std::sin(turn), 0,
                       geom::normalize(turn + 1.57)});
    }
    ++small.world.tick_;
    link.frame();
    if (step < 30) continue;
    if (step == 30) {
      before = link.sent_bytes;
      since = link.time;
    }
    for (int k = 0; k < robots; ++k) {
      const std::uint64_t tick = link.observer.world().models().at(SmallWorld::id(k).value).tick;
      driven.oldest = std::max(driven.oldest, small.world.tick_ - tick);
      driven.rows_per_frame += tick + 1 == small.world.tick_ ? 1.0 / 300 : 0;
    }
  }
  driven.bytes_per_second = static_cast<double>(link.sent_bytes - before) / (link.time - since);
  testing::Test::RecordProperty("bytes_per_second", std::to_string(driven.bytes_per_second));
  return driven;
}

TEST(DatagramViewer, two_hundred_moving_bodies_fit_64_kB_a_second_and_none_is_old) {
  const Driven near = drive_in_circles(200, {64000, 30}, {});
  EXPECT_LE(near.bytes_per_second, 64000);
  EXPECT_LE(near.oldest, 3u);
  const Driven lossy = drive_in_circles(200, {64000, 30}, {.loss = 0.1});
  EXPECT_LE(lossy.bytes_per_second, 64000);
  EXPECT_LE(lossy.oldest, 30u);
  const Driven poor = drive_in_circles(200, {16000, 30}, {});
  EXPECT_LE(poor.bytes_per_second, 16000 * 1.02);
  EXPECT_LE(poor.oldest, 30u);
  for (const Driven& each : {near, lossy, poor})
    fmt::print("{:.0f} B/s, {:.0f} rows a frame, the oldest {} frames\n", each.bytes_per_second,
               each.rows_per_frame, each.oldest);
}

TEST(DatagramViewer, nobody_starves_where_there_is_room_for_few) {
  SmallWorld small(300);
  DatagramLink link(small, {}, 4, {6000, 30});
  ASSERT_TRUE(link.settle(2000));
  link.observer.command(R"({"do":"look","x_min":-1,"y_min":-1,"x_max":1,"y_max":1,"sensors":false})");
  for (int frames = 0; frames < 30; ++frames) link.frame();
  std::map<std::uint32_t, std::uint64_t> last_heard;
  std::uint64_t longest = 0;
  const auto move_all = [&](int step) {
    for (int k = 0; k < 300; ++k)
      world::set_pose(small.world, {SmallWorld::robot(k)}, {k < 5 ? 0.5 : 1.0 * k, step * 0.01, 0, 0});
    ++small.world.tick_;
  };
  const std::uint64_t begin = small.world.tick_;
  constexpr int kFrames = 1500;
  std::map<std::uint32_t, int> times;
  for (int step = 0; step < kFrames; ++step) {
    move_all(step);
    link.frame();
    for (int k = 0; k < 300; ++k) {
      const std::uint64_t tick = link.observer.world().models().at(SmallWorld::id(k).value).tick;
      if (tick > begin && last_heard[k] != tick) ++times[k];
      const std::uint64_t before = std::max(last_heard[k], begin);
      if (tick > begin) longest = std::max(longest, tick - before);
      last_heard[k] = std::max(last_heard[k], tick);
    }
  }
  ASSERT_EQ(times.size(), 300u);                                         // everyone was heard of
  for (int k = 0; k < 5; ++k) EXPECT_GT(times[k], 2 * times[200]) << k;  // those in view far more often
  for (int k = 5; k < 300; ++k) EXPECT_GT(times[k], 1) << k;
  EXPECT_LT(longest, 700u);
}

TEST(DatagramViewer, what_is_out_of_view_goes_once_a_second_though_there_is_room) {
  SmallWorld small(20);
  DatagramLink link(small, {}, 5);
  ASSERT_TRUE(link.settle(100));
  link.observer.command(R"({"do":"look","x_min":-1,"y_min":-1,"x_max":1,"y_max":1,"sensors":false})");
  link.observer.command(R"({"do":"select","model":)" + std::to_string(SmallWorld::id(19).value) + "}");
  for (int frames = 0; frames < 10; ++frames) link.frame();
  std::map<int, std::set<std::uint64_t>> ticks;
  for (int step = 0; step < 90; ++step) {
    for (const int k : {0, 10, 19})
      world::set_pose(small.world, {SmallWorld::robot(k)}, {k * 5.0, step * 0.01, 0, 0});
    ++small.world.tick_;
    link.frame();
    for (const int k : {0, 10, 19})
      ticks[k].insert(link.observer.world().models().at(SmallWorld::id(k).value).tick);
  }
  EXPECT_GT(ticks[0].size(), 80u);   // in view
  EXPECT_GT(ticks[19].size(), 80u);  // selected
  EXPECT_LT(ticks[10].size(), 6u);
  EXPECT_TRUE(link.settle(60));
}

TEST(DatagramViewer, who_vanished_gets_little_and_is_gone_after_a_while) {
  SmallWorld small(100);
  DatagramLink link(small, {}, 6);
  ASSERT_TRUE(link.settle(100));
  link.observer_is_dead = true;
  const double left = link.time;
  for (int frames = 0; frames < 45; ++frames) {
    small.tick();
    link.frame();
  }
  const std::size_t before = link.sent_bytes;
  while (!link.viewer.is_gone(link.time)) {
    small.tick();
    link.frame();
  }
  EXPECT_NEAR(link.time - left, limits::kObserverQuietSeconds, 0.2);
  EXPECT_LT(link.sent_bytes - before, 20 * 1300u);  // two packets a second
}

TEST(DatagramViewer, a_world_that_stands_costs_next_to_nothing) {
  SmallWorld small(100);
  DatagramLink link(small, {}, 6);
  ASSERT_TRUE(link.settle(100));
  const std::size_t before = link.sent_bytes;
  for (int frames = 0; frames < 300; ++frames) {
    ++small.world.tick_;
    link.frame();
  }
  EXPECT_LT(link.sent_bytes - before, 1200u);
  EXPECT_GE(link.observer.world().tick() + 40, small.world.tick_);  // it hears the time once a second
}

TEST(DatagramViewer, a_pause_is_heard_at_once) {
  SmallWorld small(1);
  DatagramLink link(small, {}, 6);
  ASSERT_TRUE(link.settle(100));
  link.pace.paused = true;
  for (int frames = 0; frames < 3; ++frames) link.frame();
  EXPECT_TRUE(link.observer.world().paused());
}

TEST(DatagramViewer, refuses_what_an_observer_may_not_and_ends_with_who_goes_on) {
  SmallWorld small(2);
  DatagramLink link(small, {}, 6);
  ASSERT_TRUE(link.settle(100));
  link.observer.command(R"({"do":"pause"})");
  link.observer.command(R"({"do":"loook"})");
  for (int frames = 0; frames < 6; ++frames) link.frame();
  const std::vector<std::string> notices = link.observer.world().take_notices();
  ASSERT_EQ(notices.size(), 2u);
  EXPECT_EQ(notices[0], "an observer looks and selects; for the rest there is the page");
}

TEST(TextStream, texts_arrive_once_and_in_order_whatever_is_lost_doubled_or_late) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Rng rng(seed);
    StreamSender sender;
    StreamReceiver receiver(1 << 20);
    std::vector<std::string> sent, came;
    std::vector<std::pair<Piece, std::vector<std::byte>>> on_its_way;
    for (int turn = 0; turn < 4000 && (turn < 500 || sender.waiting() > 0); ++turn) {
      if (turn < 500 && rng.uniform() < 0.2) {
        std::string text(rng.bits() % 3000, 'x');
        for (char& letter : text) letter = static_cast<char>('a' + rng.bits() % 26);
        text += std::to_string(turn);
        sender.post(pack_text(text), static_cast<std::uint32_t>(turn));
        sent.push_back(text);
      }
      if (const Piece piece = sender.next(1 + rng.bits() % 1000); piece.size > 0) {
        std::vector<std::byte> bytes;
        Packer pack(bytes);
        sender.write(piece, pack);
        on_its_way.emplace_back(piece, bytes);
      }
      if (!on_its_way.empty() && rng.uniform() < 0.9) {
        const std::size_t which = rng.bits() % on_its_way.size();
        const auto [piece, bytes] = on_its_way[which];
        if (rng.uniform() > 0.2) on_its_way.erase(on_its_way.begin() + static_cast<std::ptrdiff_t>(which));
        if (rng.uniform() < 0.3) {
          sender.lost(piece);
        } else {
          ASSERT_TRUE(receiver.take(piece.at, bytes).ok());
          if (rng.uniform() < 0.1) sender.lost(piece);  // a wrong guess
        }
      }
      for (;;) {
        const auto text = receiver.next();
        ASSERT_TRUE(text.ok());
        if (!*text) break;
        came.push_back((*text)->text);
      }
      if (rng.uniform() < 0.5) ASSERT_TRUE(sender.taken(receiver.taken()));
    }
    EXPECT_EQ(came, sent) << seed;
    EXPECT_FALSE(sender.taken(sender.posted() + 1));
  }
}

TEST(TextStream, a_piece_out_of_the_window_and_a_text_that_is_none_are_refused) {
  StreamReceiver receiver(100);
  EXPECT_FALSE(receiver.take(limits::kStreamWindowBytes, std::vector<std::byte>(1)).ok());
  EXPECT_FALSE(receiver.take(~std::uint64_t{0}, std::vector<std::byte>(2)).ok());
  std::vector<std::byte> bytes;
  Packer pack(bytes);
  pack.u8(0);
  pack.varint(0);
  pack.varint(101);
  ASSERT_TRUE(receiver.take(0, bytes).ok());
  EXPECT_FALSE(receiver.next().ok());
  // A frame that says it unpacks to more than there may be.
  StreamSender sender;
  sender.post(pack_text(std::string(100000, 'a')), 0);
  const Piece piece = sender.next(1000);
  std::vector<std::byte> packed;
  Packer other(packed);
  sender.write(piece, other);
  StreamReceiver small(1000);
  ASSERT_TRUE(small.take(0, packed).ok());
  EXPECT_FALSE(small.next().ok());
}

TEST(Datagram, handshakes_come_back_as_they_were) {
  const auto again = [](const Datagram& datagram) {
    const Result<Datagram> parsed = parse_datagram(encode(datagram));
    PLAYHOUSE_ASSERT(parsed.ok());
    return *parsed;
  };
  EXPECT_EQ(std::get<Hello>(again(Hello{1, 5})).nonce, 5u);
  const auto challenge = std::get<Challenge>(again(Challenge{5, 6}));
  EXPECT_EQ(challenge.cookie, 6u);
  const auto join = std::get<JoinRequest>(again(JoinRequest{1, 5, 6, {64000, 30}, "blue-chair-7"}));
  EXPECT_EQ(join.nonce, 5u);
  EXPECT_EQ(join.cookie, 6u);
  EXPECT_EQ(join.wanted.bytes_per_second, 64000u);
  EXPECT_EQ(join.wanted.frames_per_second, 30u);
  EXPECT_EQ(join.token, "blue-chair-7");
  EXPECT_EQ(std::get<Welcome>(again(Welcome{1, 2, {3, 4}})).terms.frames_per_second, 4u);
  EXPECT_EQ(std::get<Refusal>(again(Refusal{1, "no"})).why, "no");
  EXPECT_EQ(std::get<Bye>(again(Bye{1, "ended"})).why, "ended");
}

TEST(Datagram, a_short_hello_is_none_because_the_answer_would_be_longer) {
  std::vector<std::byte> hello = encode(Hello{1, 5});
  EXPECT_EQ(hello.size(), kHelloBytes);
  hello.pop_back();
  EXPECT_FALSE(parse_datagram(hello).ok());
  EXPECT_LE(encode(Challenge{~0ull, ~0ull}).size(), kHelloBytes);
}

RC_GTEST_PROP(DatagramLaw, any_bytes_are_a_datagram_or_refused, (const std::vector<std::uint8_t>& bytes)) {
  std::vector<std::uint8_t> framed{'P', static_cast<std::uint8_t>(*rc::gen::inRange(0, 9))};
  framed.insert(framed.end(), bytes.begin(), bytes.end());
  const auto parsed = parse_datagram(std::as_bytes(std::span(framed)));
  if (!parsed) RC_ASSERT(!parsed.error().text.empty());
}

TEST(DatagramChannel, goes_on_after_more_packets_than_32_bits_count) {
  constexpr Seq kMany = 0xFFFFFFFEu;
  constexpr std::size_t kSession = 2 + 8;  // bytes in front of what a channel reads
  DatagramChannel one(7, 1000, kMany), other(7, 1000);
  one.post(pack_text("a text"));
  std::vector<std::byte> packet;
  for (Seq k = 1; k <= 5; ++k) {
    ASSERT_EQ(one.write(static_cast<double>(k), 100, packet), kMany + k);
    const Result<ReceivedPacket> heard =
        other.receive(std::span(packet).subspan(kSession), static_cast<double>(k));
    ASSERT_TRUE(heard.ok()) << heard.error().text;
    EXPECT_TRUE(heard->is_new);
    EXPECT_EQ(heard->seq, kMany + k);
  }
  const auto text = other.next_text();
  ASSERT_TRUE(text.ok() && *text);
  EXPECT_EQ((*text)->after, kMany);
  other.write(6, 100, packet);
  ASSERT_TRUE(one.receive(std::span(packet).subspan(kSession), 6).ok());
  EXPECT_EQ(one.settle(6).acknowledged.size(), 5u);
}

/// Every bit of what both ends get is turned once; neither may crash, and the session goes on or ends.
TEST(DatagramLink, damaged_packets_are_taken_or_end_the_session) {
  SmallWorld small(5);
  std::size_t went_on = 0;
  for (std::size_t damage = 0; damage < 400; ++damage) {
    DatagramLink link(small, {}, damage);
    std::vector<std::byte> last;
    link.on_sent = [&](std::span<const std::byte> datagram) {
      last.assign(datagram.begin(), datagram.end());
    };
    for (int frames = 0; frames < 4; ++frames) {
      link.faults.loss = frames < 3 ? 0 : 1;  // the last comes damaged alone
      small.tick();
      link.frame();
    }
    link.faults.loss = 0;
    last[2 + 8 + damage / 8 % (last.size() - 10)] ^= static_cast<std::byte>(1 << damage % 8);
    link.observer.receive(last, link.time);
    const bool is_open = link.viewer.receive(std::span(last).subspan(10), link.time).ok();
    link.somebody_else_writes = true;  // to the viewer: the next packets may be refused
    if (is_open && !link.observer.ended()) went_on += link.settle(100);
  }
  EXPECT_GT(went_on, 200u);
}

TEST(Importance, is_higher_for_what_is_selected_near_and_moved_far) {
  Wish wish;
  EXPECT_EQ(importance(wish, false, {1000, 1000}, 0), 1);
  EXPECT_GT(importance(wish, false, {0, 0}, 500), importance(wish, false, {0, 0}, 5));
  EXPECT_GT(importance(wish, true, {0, 0}, 0), importance(wish, false, {0, 0}, 1e9));
  wish.view = {-1, -1, 1, 1};
  EXPECT_GT(importance(wish, false, {0, 0}, 0), importance(wish, false, {50, 0}, 0));
  EXPECT_EQ(importance(wish, false, {1e6, 0}, 0), 0.05);
  EXPECT_FALSE(is_out_of_view(wish, {1, 1}));
  EXPECT_TRUE(is_out_of_view(wish, {1.01, 1}));
}

}  // namespace
}  // namespace playhouse::replicate
