#include "playhouse/replicate/delta.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <numeric>
#include <set>

#include "playhouse/base/limits.h"
#include "playhouse/replicate/quantize.h"
#include "playhouse/replicate/small_world.h"
#include "playhouse/replicate/viewer.h"
#include "playhouse/world/drawing.h"
#include "playhouse/world/population/population.h"
#include "playhouse/world/saving/state.h"

namespace playhouse::replicate {
namespace {

constexpr geom::Box kEverywhere{-1000, -1000, 1000, 1000};

std::map<world::ModelRow, std::vector<SentCorner>> drawn_in(const Replica& replica) {
  std::map<world::ModelRow, std::vector<SentCorner>> drawings;
  for (const auto& [row, drawing] : replica.drawings) drawings[row] = *drawing;
  return drawings;
}

/// A viewer at both ends of a wire: what the writer thinks it holds, and what the packets made of it.
struct Pair {
  explicit Pair(const std::shared_ptr<const Layout>& layout) : sender(layout), receiver(layout) {}

  Sent send(const Snapshot& snapshot, const Wish& wish, std::size_t budget) {
    const Sent sent = writer.write(snapshot, wish, ++frame, budget, sender, packet);
    const Result<std::uint32_t> applied = apply_packet(packet, receiver);
    RC_ASSERT(applied.ok());
    RC_ASSERT(*applied == frame);
    RC_ASSERT(receiver.models == sender.models);
    RC_ASSERT(receiver.says == sender.says);
    RC_ASSERT(receiver.scans == sender.scans);
    RC_ASSERT(receiver.views == sender.views);
    RC_ASSERT(drawn_in(receiver) == drawn_in(sender));
    return sent;
  }

  DeltaWriter writer;
  Replica sender, receiver;
  std::vector<std::byte> packet;
  std::uint32_t frame = 0;
};

void subscribe_all(world::World& world) {
  for (const world::ModelRow row : world.models.rows()) world::subscribe(world, row);
}

Wish any_wish(int robots) {
  Wish wish;
  wish.sensors = *rc::gen::arbitrary<bool>();
  if (*rc::gen::arbitrary<bool>()) wish.view = kEverywhere;
  if (*rc::gen::arbitrary<bool>()) wish.selected = SmallWorld::id(*rc::gen::inRange(0, robots));
  return wish;
}

/// Somebody comes, goes, or is taken along.
void change_population(SmallWorld& small) {
  world::World& world = small.world;
  const auto any = [&] { return world.models.id[{*rc::gen::inRange(0u, world.models.id.next().index)}]; };
  switch (*rc::gen::inRange(0, 4)) {
    case 0:
      static_cast<void>(world::spawn(world, SmallWorld::robot(0), {1, 2, 0, 3}));
      subscribe_all(world);
      return;
    case 1:
      static_cast<void>(world::spawn(world, small.puck(), {1, 2, 0, 3}));
      return;
    case 2:
      if (world.models.size() > 1) static_cast<void>(world::despawn(world, any()));
      return;
    default:
      static_cast<void>(world::attach(world, any(), any(), {0.2, 0, 0, 0}));
      return;
  }
}

/// Some say something, or nothing any more, and get flags.
void speak(world::World& world) {
  if (world.models.size() == 0) return;
  for (int changes = *rc::gen::inRange(0, 4); changes > 0; --changes) {
    const world::ModelRow row{
        *rc::gen::inRange<std::uint32_t>(0, static_cast<std::uint32_t>(world.models.size()))};
    world::set_say(world, row, std::string(*rc::gen::element<std::size_t>(0, 1, 60, 500), 'a'));
    world::add_flags(world, row, *rc::gen::inRange(-3, 300));
  }
}

/// Clients draw, and clear what they drew.
void draw(world::World& world) {
  if (world.models.size() == 0) return;
  for (int changes = *rc::gen::inRange(0, 4); changes > 0; --changes) {
    const world::ModelRow row{
        *rc::gen::inRange<std::uint32_t>(0, static_cast<std::uint32_t>(world.models.size()))};
    const auto corners = *rc::gen::inRange<std::uint32_t>(1, 4),
               shapes = *rc::gen::inRange<std::uint32_t>(1, 60);
    std::vector<geom::Vec3> points(std::size_t{corners} * shapes);
    for (geom::Vec3& p : points) p = {*rc::gen::inRange(-3000, 3000) / 1000.0, 0.5, -2e6};
    if (*rc::gen::arbitrary<bool>()) world::clear_drawing(world, row, world::kLayer2d);
    if (*rc::gen::arbitrary<bool>())
      world::draw(world, row, {*rc::gen::inRange<std::uint32_t>(0, 2), corners, {1, 0, 0, 1}, points});
  }
}

/// The oracle: what a viewer with this wish must hold in the end.
void expect_whole(const Snapshot& snapshot, const Wish& wish, const Replica& replica) {
  const Layout& layout = *snapshot.layout;
  const auto wanted = [&](world::ModelRow model) {
    return (wish.sensors && !wish.view.empty()) ||
           (wish.selected && layout.id[layout.root[model]] == *wish.selected);
  };
  RC_ASSERT(replica.models == snapshot.models);
  std::map<world::ModelRow, std::string> says;
  for (const Said& said : snapshot.says) says[said.model] = said.text;
  RC_ASSERT(replica.says == says);
  std::map<world::ModelRow, std::vector<SentCorner>> drawings;
  for (const ModelDrawing& drawn : snapshot.drawings) drawings[drawn.model] = *drawn.drawing;
  RC_ASSERT(drawn_in(replica) == drawings);
  ByRow<world::SensorTable, std::vector<std::uint16_t>> scans(layout.sensors.size());
  for (const SensorScan& scan : snapshot.scans) {
    if (!wanted(layout.sensors[scan.sensor].model)) continue;
    const auto first = snapshot.beams.begin() + scan.first;
    scans[scan.sensor].assign(first, first + layout.sensors[scan.sensor].beam_count);
  }
  RC_ASSERT(replica.scans == scans);
  std::map<std::pair<std::uint32_t, world::ModelRow>, std::vector<std::int32_t>> expected;
  for (const Viewed& viewed : snapshot.viewed) {
    const bool is_selected = wish.selected && layout.id[layout.root[viewed.model]] == *wish.selected;
    const When when = views()[viewed.view].when;
    if (when == When::kShown && !wanted(viewed.model)) continue;
    if (when == When::kSelected && !is_selected) continue;
    const auto first = snapshot.values.begin() + viewed.first;
    expected[{viewed.view, viewed.model}].assign(first, first + viewed.count);
  }
  RC_ASSERT(replica.views == expected);
}

RC_GTEST_PROP(DeltaLaw,
              packets_bring_a_viewer_to_the_snapshot_whatever_it_looks_at_and_however_small_they_are, ()) {
  const int robots = *rc::gen::inRange(1, 12);
  SmallWorld small(robots, *rc::gen::inRange(0, 3));
  subscribe_all(small.world);
  auto layout = small.layout();
  Pair pair(layout);
  Snapshot snapshot;
  for (int round = *rc::gen::inRange(1, 6); round > 0; --round) {
    const Wish wish = any_wish(robots);
    for (int changes = *rc::gen::inRange(0, 3); changes > 0; --changes) change_population(small);
    speak(small.world);
    draw(small.world);
    if (layout->population != small.world.population()) {
      layout = small.layout({}, layout.get());
      pair.sender.follow(layout);
      pair.receiver.follow(layout);
    }
    for (int ticks = *rc::gen::inRange(0, 3); ticks > 0; --ticks) small.tick();
    capture(small.world, {}, layout, interest_of(wish), snapshot);
    const auto budget = static_cast<std::size_t>(*rc::gen::inRange(40, 400));
    int packets = 0;
    while (pair.send(snapshot, wish, budget) == Sent::kPart) RC_ASSERT(++packets < 200);
    expect_whole(snapshot, wish, pair.receiver);
    RC_ASSERT(pair.send(snapshot, wish, budget) == Sent::kNothing);
  }
}

RC_GTEST_PROP(DeltaLaw, any_bytes_are_applied_or_refused, (const std::vector<std::uint8_t>& bytes)) {
  SmallWorld small(2);
  const auto layout = small.layout();
  Replica replica(layout);
  const Result<std::uint32_t> applied = apply_packet(std::as_bytes(std::span(bytes)), replica);
  RC_ASSERT(applied.ok() || !applied.error().text.empty());
}

TEST(Delta, a_packet_stays_near_its_budget_and_shows_the_selected_robot_first) {
  SmallWorld small(300);
  const auto layout = small.layout();
  for (std::uint32_t k = 0; k < 300; ++k)
    world::set_pose(small.world, {SmallWorld::robot(static_cast<int>(k))}, {50, 50, 0, 1});
  Snapshot snapshot;
  capture(small.world, {}, layout, {}, snapshot);
  Pair pair(layout);
  Wish wish;
  wish.selected = SmallWorld::id(299);
  EXPECT_EQ(pair.send(snapshot, wish, 400), Sent::kPart);
  EXPECT_LT(pair.packet.size(), 450u);
  EXPECT_EQ(pair.receiver.models[{SmallWorld::robot(299)}].x, 50000);
  EXPECT_NE(pair.receiver.models[{SmallWorld::robot(298)}].x, 50000);
}

TEST(Delta, what_is_in_view_goes_before_the_rest) {
  SmallWorld small(100);
  const auto layout = small.layout();
  for (int k = 0; k < 100; ++k)
    world::set_pose(small.world, {SmallWorld::robot(k)}, {k < 90 ? 500.0 : 2.0, 0, 0, 1});
  Snapshot snapshot;
  capture(small.world, {}, layout, {}, snapshot);
  Pair pair(layout);
  Wish wish;
  wish.view = {0, -5, 5, 5};
  pair.send(snapshot, wish, 250);
  for (int k = 90; k < 100; ++k) EXPECT_EQ(pair.receiver.models[{SmallWorld::robot(k)}].x, 2000) << k;
}

TEST(Delta, what_had_no_room_goes_by_priority_and_in_the_end_all_of_it_goes) {
  SmallWorld small(200);
  const auto layout = small.layout();
  Pair pair(layout);
  Wish wish;
  wish.view = {-10, -10, 10, 10};
  Snapshot snapshot;
  std::vector<int> updates(200);
  for (int frame = 0; frame < 400; ++frame) {
    // In the middle of the view, at its edge, and outside, all moving alike.
    for (int k = 0; k < 200; ++k)
      world::set_pose(small.world, {SmallWorld::robot(k)},
                      {k < 50    ? 0.0
                       : k < 100 ? 9.0
                                 : 300.0,
                       0.001 * frame, 0, 0});
    capture(small.world, {}, layout, {}, snapshot);
    const world::ByModel<ModelState> before = pair.receiver.models;
    EXPECT_EQ(pair.send(snapshot, wish, 100), Sent::kPart);
    EXPECT_LT(pair.packet.size(), 120u);
    for (int k = 0; k < 200; ++k)
      updates[static_cast<std::size_t>(k)] +=
          before[{SmallWorld::robot(k)}] != pair.receiver.models[{SmallWorld::robot(k)}];
  }
  const auto mean = [&](int begin, int end) {
    return std::accumulate(updates.begin() + begin, updates.begin() + end, 0.0) / (end - begin);
  };
  EXPECT_GT(mean(0, 50), 1.5 * mean(50, 100)) << "the middle of the view";
  EXPECT_GT(mean(50, 100), 3 * mean(100, 200)) << "outside the view";
  EXPECT_GT(*std::ranges::min_element(updates), 1) << "nothing starves";
  int packets = 0;
  while (pair.send(snapshot, wish, 100) == Sent::kPart) ASSERT_LT(++packets, 100);
  EXPECT_EQ(pair.receiver.models, snapshot.models);
}

TEST(Delta, an_unchanged_world_costs_a_head_and_five_ends) {
  SmallWorld small(50);
  const auto layout = small.layout();
  Snapshot snapshot;
  capture(small.world, {}, layout, {}, snapshot);
  Pair pair(layout);
  EXPECT_EQ(pair.send(snapshot, {}, 1000), Sent::kNothing);
  EXPECT_EQ(pair.packet.size(), 1u + 1 + 1 + 1 + 4 + 4 + 5);
}

TEST(Delta, a_sensor_that_stops_measuring_is_taken_back) {
  SmallWorld small(1);
  const auto layout = small.layout();
  subscribe_all(small.world);
  small.tick();
  Wish wish;
  wish.selected = SmallWorld::id(0);
  Snapshot snapshot;
  capture(small.world, {}, layout, interest_of(wish), snapshot);
  Pair pair(layout);
  pair.send(snapshot, wish, 1000);
  EXPECT_EQ(std::ranges::count_if(pair.receiver.scans, [](const auto& beams) { return !beams.empty(); }), 3);
  for (const world::ModelRow row : small.world.models.rows()) world::unsubscribe(small.world, row);
  capture(small.world, {}, layout, interest_of(wish), snapshot);
  pair.send(snapshot, wish, 1000);
  EXPECT_TRUE(std::ranges::all_of(pair.receiver.scans, [](const auto& beams) { return beams.empty(); }));
  EXPECT_TRUE(std::ranges::all_of(pair.receiver.views, [](const auto& held) {
    return views()[held.first.first].when == When::kSelected;
  }));
}

TEST(Delta, tells_how_grippers_stand_whoever_looks_and_whether_anybody_uses_them) {
  SmallWorld small(1, 2);
  const auto layout = small.layout();
  Snapshot snapshot;
  Pair pair(layout);
  const auto told = [&] {
    std::vector<std::int32_t> paddles;
    capture(small.world, {}, layout, {}, snapshot);
    pair.send(snapshot, {}, 1000);
    for (const auto& [key, values] : pair.receiver.views) {
      EXPECT_EQ(views()[key.first].when, When::kChanged);
      paddles.push_back(values[0]);
    }
    return paddles;
  };
  EXPECT_EQ(told(), (std::vector<std::int32_t>{0, 0}));
  small.world.grippers.paddles[{1}] = 0.25;
  EXPECT_EQ(told(), (std::vector<std::int32_t>{0, 250}));
}

TEST(Delta, all_texts_go_those_in_view_first_and_each_once) {
  SmallWorld small(60);
  const auto layout = small.layout();
  for (int k = 0; k < 60; ++k) {
    world::set_pose(small.world, {SmallWorld::robot(k)}, {k < 55 ? 500.0 : 2.0, 0, 0, 0});
    world::set_say(small.world, {SmallWorld::robot(k)}, std::string(100, static_cast<char>('A' + k)));
  }
  Snapshot snapshot;
  capture(small.world, {}, layout, {}, snapshot);
  Pair pair(layout);
  Wish wish;
  wish.view = {0, -5, 5, 5};
  while (pair.send(snapshot, wish, 1000) == Sent::kPart && pair.receiver.says.empty()) {
  }
  EXPECT_TRUE(pair.receiver.says.contains({SmallWorld::robot(55)}));
  EXPECT_FALSE(pair.receiver.says.contains({SmallWorld::robot(0)}));
  std::size_t bytes = pair.packet.size();
  while (pair.send(snapshot, wish, 1000) == Sent::kPart) bytes += pair.packet.size();
  EXPECT_EQ(pair.receiver.says.size(), 60u);
  EXPECT_LT(bytes, 60u * 150);
  EXPECT_EQ(pair.send(snapshot, wish, 1000), Sent::kNothing);
}

TEST(Delta, a_viewer_that_comes_late_hears_what_is_said_and_no_more) {
  SmallWorld small(2);
  world::set_say(small.world, {SmallWorld::robot(0)}, "before");
  world::set_say(small.world, {SmallWorld::robot(1)}, "over");
  world::set_say(small.world, {SmallWorld::robot(1)}, "");
  world::add_flags(small.world, {SmallWorld::robot(1)}, 7);
  const auto layout = small.layout();
  Snapshot snapshot;
  capture(small.world, {}, layout, {}, snapshot);
  Pair late(layout);
  late.send(snapshot, {}, 1000);
  EXPECT_EQ(late.receiver.says, (std::map<world::ModelRow, std::string>{{{SmallWorld::robot(0)}, "before"}}));
  EXPECT_EQ(late.receiver.models[{SmallWorld::robot(1)}].flags, 7u);
}

TEST(Delta, drawings_are_sent_among_scans_that_fill_every_frame) {
  constexpr std::size_t kBudget = 64;  // less than the scans of a robot
  constexpr std::uint32_t kFrames = 20;
  SmallWorld small(3);
  const auto layout = small.layout();
  subscribe_all(small.world);
  Wish wish;
  wish.view = kEverywhere;
  wish.sensors = true;
  Snapshot snapshot;
  Pair pair(layout);
  std::set<SentDrawing> seen;
  for (std::uint32_t frame = 0; frame < kFrames; ++frame) {
    small.tick();
    const world::ModelRow robot{SmallWorld::robot(static_cast<int>(frame % 2))};
    world::clear_drawing(small.world, robot, world::kLayer2d);
    const std::vector<geom::Vec3> point{{0.1 * frame, 0, 0}};
    ASSERT_TRUE(world::draw(small.world, robot, {world::kLayer2d, 1, {1, 0, 0, 1}, point}));
    capture(small.world, {}, layout, interest_of(wish), snapshot);
    ASSERT_FALSE(snapshot.scans.empty());
    pair.send(snapshot, wish, kBudget);
    for (const auto& [row, drawing] : pair.receiver.drawings) seen.insert(drawing);
  }
  EXPECT_EQ(pair.receiver.drawings.size(), 2u);
  EXPECT_GE(seen.size(), kFrames / 2 - 1) << "every other frame has one";
}

TEST(Delta, a_state_that_is_loaded_says_what_it_said) {
  SmallWorld small(2);
  const auto layout = small.layout();
  std::vector<std::byte> state;
  ASSERT_TRUE(world::save_state(small.world, state).ok());
  world::set_say(small.world, {SmallWorld::robot(0)}, "later");
  world::add_flags(small.world, {SmallWorld::robot(0)}, 1);
  Snapshot snapshot;
  Pair pair(layout);
  const auto says = [&] {
    capture(small.world, {}, layout, {}, snapshot);
    pair.send(snapshot, {}, 1000);
    return pair.receiver.says;
  };
  EXPECT_EQ(says().size(), 1u);
  ASSERT_TRUE(world::load_state(small.world, state).ok());
  EXPECT_TRUE(says().empty());
  EXPECT_EQ(pair.receiver.models[{SmallWorld::robot(0)}].flags, 0u);
}

TEST(Snapshot, copies_texts_only_when_somebody_has_said_something) {
  SmallWorld small(2);
  const auto layout = small.layout();
  world::set_say(small.world, {SmallWorld::robot(0)}, "a");
  Snapshot snapshot;
  capture(small.world, {}, layout, {}, snapshot);
  ASSERT_EQ(snapshot.says.size(), 1u);
  snapshot.says[0].text = "untouched";
  capture(small.world, {}, layout, {}, snapshot);
  EXPECT_EQ(snapshot.says[0].text, "untouched");
  world::set_say(small.world, {SmallWorld::robot(1)}, "b");
  capture(small.world, {}, layout, {}, snapshot);
  ASSERT_EQ(snapshot.says.size(), 2u);
  EXPECT_EQ(snapshot.says[0].text, "a");
}

TEST(Snapshot, shares_drawings_that_have_not_changed_with_the_one_before) {
  SmallWorld small(2);
  const auto layout = small.layout();
  const auto draw = [&](int robot, double x) {
    const std::vector<geom::Vec3> point{{x, 0, 0}};
    return world::draw(small.world, {SmallWorld::robot(robot)}, {world::kLayer2d, 1, {1, 0, 0, 1}, point});
  };
  ASSERT_TRUE(draw(0, 1) && draw(1, 1));
  Snapshot first, second;
  capture(small.world, {}, layout, {}, first);
  world::clear_drawing(small.world, {SmallWorld::robot(0)}, world::kLayer2d);
  ASSERT_TRUE(draw(0, 1) && draw(1, 2));
  capture(small.world, {}, layout, {}, second, &first);
  ASSERT_EQ(second.drawings.size(), 2u);
  EXPECT_EQ(second.drawings[0].drawing, first.drawings[0].drawing) << "drawn anew as it was";
  EXPECT_EQ(second.drawings[1].drawing->size(), 2u);
  world::clear_drawing(small.world, {SmallWorld::robot(0)}, world::kLayer2d);
  capture(small.world, {}, layout, {}, first, &second);
  ASSERT_EQ(first.drawings.size(), 1u);
  EXPECT_EQ(first.drawings[0].drawing, second.drawings[1].drawing);
}

TEST(Snapshot, captures_sensors_only_of_robots_in_view_or_selected) {
  SmallWorld small(3);
  const auto layout = small.layout();
  subscribe_all(small.world);
  small.tick();
  for (int k = 0; k < 3; ++k) world::set_pose(small.world, {SmallWorld::robot(k)}, {100.0 * k, 0, 0, 0});
  Snapshot snapshot;
  capture(small.world, {}, layout, {}, snapshot);
  EXPECT_TRUE(snapshot.scans.empty());
  Interest interest;
  interest.view = {-1, -1, 1, 1};
  interest.selected = {SmallWorld::id(2)};
  capture(small.world, {}, layout, interest, snapshot);
  ASSERT_EQ(snapshot.scans.size(), 6u);
  EXPECT_EQ(snapshot.scans[0].sensor, world::SensorRow{0});
  EXPECT_EQ(snapshot.scans[3].sensor, world::SensorRow{6});
}

TEST(Snapshot, holds_no_more_beams_than_the_limit_and_those_of_selected_robots_first) {
  constexpr std::uint32_t kBeams = 60000;
  constexpr std::uint32_t kScanners = 6;  // 4 fit
  scene::SceneDesc scene;
  for (std::uint32_t k = 0; k < kScanners; ++k) {
    scene::ModelDesc& model = scene.models.emplace_back();
    model.name = model.alias = "s" + std::to_string(k);
    model.kind = scene::ModelKind::kRanger;
    model.alwayson = true;
    model.sensors.resize(1);
    model.sensors[0].samples = kBeams;
  }
  world::World world(scene, 1);
  world.rangers.measured_tick.assign(kScanners, 1);
  const Prototypes prototypes(scene);
  const auto layout = std::make_shared<const Layout>(world, prototypes, DeviceNames());
  Snapshot snapshot;
  Interest interest;
  interest.view = {-1, -1, 1, 1};
  capture(world, {}, layout, interest, snapshot);
  EXPECT_EQ(snapshot.scans.size(), 4u);
  EXPECT_TRUE(snapshot.beams_full);
  interest.selected = {{5}};
  capture(world, {}, layout, interest, snapshot);
  ASSERT_EQ(snapshot.scans.size(), 4u);
  EXPECT_EQ(snapshot.scans.back().sensor, world::SensorRow{5});
  interest.selected = {{0}, {1}, {2}, {3}, {4}, {5}};
  capture(world, {}, layout, interest, snapshot);
  EXPECT_LE(snapshot.beams.size(), limits::kSnapshotBeams);
  EXPECT_TRUE(snapshot.beams_full);
}

TEST(Quantization, keeps_millimetres_and_turns_and_survives_what_is_no_number) {
  EXPECT_EQ(quantize(1.2344, 1000), 1234);
  EXPECT_EQ(quantize(-1.2346, 1000), -1235);
  EXPECT_EQ(quantize(1e300, 1000), 2147483647);
  EXPECT_EQ(quantize(std::nan(""), 1000), 0);
  EXPECT_EQ(quantize_angle(geom::kPi / 2), 16384);
  EXPECT_EQ(quantize_angle(-geom::kPi / 2), 49152);
  EXPECT_EQ(quantize_angle(-1e-9), 0);
  EXPECT_EQ(quantize_range(4, 8), 32768);
  EXPECT_EQ(quantize_range(9, 8), 65535);
  EXPECT_EQ(quantize_range(std::nan(""), 8), 65535);
}

TEST(Viewer, gets_no_more_frames_than_it_acknowledges) {
  SmallWorld small(3);
  const auto layout = small.layout();
  Viewer viewer(layout);
  ChangesTexts texts;
  Snapshot snapshot;
  std::vector<std::byte> packet;
  std::uint32_t frames = 0;
  for (int k = 0; k < 20; ++k) {
    small.tick();
    capture(small.world, {}, layout, {}, snapshot);
    frames += viewer.next_frame(snapshot, Emit::kIfChanged, texts, packet).packet;
  }
  EXPECT_EQ(frames, limits::kViewerFramesInFlight);
  EXPECT_FALSE(viewer.acknowledge(frames + 1).ok());
  EXPECT_TRUE(viewer.acknowledge(1).ok());
  EXPECT_TRUE(viewer.next_frame(snapshot, Emit::kIfChanged, texts, packet).packet);
  EXPECT_FALSE(viewer.next_frame(snapshot, Emit::kAlways, texts, packet).packet);
}

TEST(Viewer, a_still_world_sends_nothing_unless_asked_to) {
  SmallWorld small(3);
  const auto layout = small.layout();
  Viewer viewer(layout);
  ChangesTexts texts;
  Snapshot snapshot;
  std::vector<std::byte> packet;
  capture(small.world, {}, layout, {}, snapshot);
  EXPECT_FALSE(viewer.next_frame(snapshot, Emit::kIfChanged, texts, packet).packet);
  EXPECT_TRUE(viewer.next_frame(snapshot, Emit::kAlways, texts, packet).packet);
}

TEST(Viewer, selects_the_robot_of_a_part_and_nothing_where_there_is_none) {
  SmallWorld small(3);
  Viewer viewer(small.layout());
  viewer.select({world::ModelId{SmallWorld::robot(1) + 2}});
  EXPECT_EQ(viewer.wish().selected, SmallWorld::id(1));
  viewer.select({world::ModelId{1000}});
  EXPECT_EQ(viewer.wish().selected, std::nullopt);
  viewer.select({SmallWorld::id(0)});
  viewer.select({std::nullopt});
  EXPECT_EQ(viewer.wish().selected, std::nullopt);
}

}  // namespace
}  // namespace playhouse::replicate
