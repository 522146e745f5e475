#include "playhouse/replicate/snapshot_feed.h"

#include <gtest/gtest.h>

#include <memory>
#include <set>
#include <thread>
#include <utility>
#include <vector>

#include "playhouse/replicate/small_world.h"

namespace playhouse::replicate {
namespace {

class SnapshotFeedTest : public testing::Test {
 protected:
  /// A server of viewers, whose tasks are run by hand.
  struct Server {
    explicit Server(SnapshotFeed& feed)
        : reader(
              feed, [this](std::function<void()> task) { tasks.push_back(std::move(task)); },
              [this] {
                ++turns;
                reader.take();
              }) {}
    void run() {
      for (const auto& task : std::exchange(tasks, {})) task();
    }
    std::vector<std::function<void()>> tasks;
    int turns = 0;
    SnapshotReader reader;
  };

  void show() {
    small_.tick();
    feed_.show(small_.world, {});
    time_ += 1;
  }

  double time_ = 0;
  SmallWorld small_{3};
  SnapshotFeed feed_{small_.world, {}, [this] { return time_; }};
  Server page_{feed_}, observers_{feed_};
};

TEST_F(SnapshotFeedTest, wants_a_capture_for_each_frame_while_anybody_watches) {
  EXPECT_FALSE(feed_.wants_show());
  observers_.reader.watch(true);
  EXPECT_TRUE(feed_.wants_show());
  feed_.show(small_.world, {});
  EXPECT_FALSE(feed_.wants_show());
  time_ = kFramePeriod / 2;
  page_.reader.watch(true);
  EXPECT_FALSE(feed_.wants_show()) << "one capture is for both";
  time_ = kFramePeriod;
  EXPECT_TRUE(feed_.wants_show());
  observers_.reader.watch(false);
  EXPECT_TRUE(feed_.wants_show());
  page_.reader.watch(false);
  EXPECT_FALSE(feed_.wants_show());
}

TEST_F(SnapshotFeedTest, all_readers_see_the_same_snapshot) {
  EXPECT_EQ(page_.reader.snapshot().models.size(), small_.world.models.size());
  EXPECT_EQ(&page_.reader.snapshot(), &observers_.reader.snapshot());
  for (Server* server : {&page_, &observers_}) server->reader.watch(true);
  show();
  page_.run();
  EXPECT_EQ(page_.reader.snapshot().tick, 1u);
  EXPECT_EQ(observers_.reader.snapshot().tick, 0u);
  observers_.run();
  EXPECT_EQ(&page_.reader.snapshot(), &observers_.reader.snapshot());
}

TEST_F(SnapshotFeedTest, tells_those_who_watch_once_before_they_take) {
  page_.reader.watch(true);
  show();
  show();
  EXPECT_EQ(page_.tasks.size(), 1u);
  EXPECT_EQ(observers_.tasks.size(), 0u);
  page_.run();
  EXPECT_EQ(page_.reader.snapshot().tick, 2u);
  show();
  page_.run();
  EXPECT_EQ(page_.turns, 2);
  EXPECT_EQ(page_.reader.snapshot().tick, 3u);
}

TEST_F(SnapshotFeedTest, what_was_posted_does_nothing_after_the_end_of_its_reader) {
  auto late = std::make_unique<Server>(feed_);
  late->reader.watch(true);
  show();
  const auto tasks = std::exchange(late->tasks, {});
  ASSERT_EQ(tasks.size(), 1u);
  late.reset();
  tasks.front()();
  show();
}

TEST_F(SnapshotFeedTest, who_is_slow_keeps_its_snapshot_and_no_memory_is_added) {
  observers_.reader.watch(true);
  const std::vector<ModelState> before = page_.reader.snapshot().models;
  std::set<const Snapshot*> snapshots;
  std::set<const ModelState*> memory;
  for (std::uint64_t tick = 1; tick <= 50; ++tick) {
    show();
    observers_.run();
    ASSERT_EQ(observers_.reader.snapshot().tick, tick);
    snapshots.insert(&observers_.reader.snapshot());
    memory.insert(observers_.reader.snapshot().models.data());
  }
  EXPECT_EQ(page_.reader.snapshot().tick, 0u);
  EXPECT_EQ(page_.reader.snapshot().models, before);
  EXPECT_LE(snapshots.size(), 3u) << "of four, one is the page's";
  EXPECT_EQ(memory.size(), snapshots.size());
}

TEST_F(SnapshotFeedTest, captures_what_any_reader_wants) {
  for (const world::ModelRow row : small_.world.models.rows()) world::subscribe(small_.world, row);
  page_.reader.set_interest({.selected = {SmallWorld::id(2)}});
  observers_.reader.set_interest({.selected = {SmallWorld::id(0), SmallWorld::id(2)}});
  const auto robots = [this] {
    show();
    page_.reader.take();
    const Snapshot& snapshot = page_.reader.snapshot();
    std::set<std::uint32_t> robots;
    for (const SensorScan& scan : snapshot.scans)
      robots.insert(snapshot.layout->root[snapshot.layout->sensors[scan.sensor].model].index);
    return robots;
  };
  using Rows = std::set<std::uint32_t>;
  EXPECT_EQ(robots(), (Rows{SmallWorld::robot(0), SmallWorld::robot(2)}));
  observers_.reader.set_interest({});
  EXPECT_EQ(robots(), Rows{SmallWorld::robot(2)});
  observers_.reader.set_interest({.view = {-100, -100, 100, 100}, .selected = {}});
  EXPECT_EQ(robots(), (Rows{SmallWorld::robot(0), SmallWorld::robot(1), SmallWorld::robot(2)}));
  page_.reader.set_interest({});
  observers_.reader.set_interest({});
  EXPECT_EQ(robots(), Rows{});
}

TEST_F(SnapshotFeedTest, a_new_population_is_one_layout_for_all) {
  ASSERT_TRUE(world::despawn(small_.world, SmallWorld::id(1)).ok());
  const std::shared_ptr<const Layout> before = page_.reader.snapshot().layout;
  show();
  page_.reader.take();
  observers_.reader.take();
  EXPECT_NE(page_.reader.snapshot().layout, before);
  EXPECT_EQ(page_.reader.snapshot().layout, observers_.reader.snapshot().layout);
  EXPECT_EQ(page_.reader.snapshot().layout->population, small_.world.population());
}

/// The thread sanitizer sees whether a snapshot is written while it is read.
TEST_F(SnapshotFeedTest, snapshots_stay_as_they_are_while_other_threads_read_them) {
  constexpr std::uint64_t kTicks = 3000;
  const auto read = [](SnapshotReader& reader) {
    for (std::uint64_t last = 0; last < kTicks; last = reader.snapshot().tick) {
      reader.take();
      const Snapshot& snapshot = reader.snapshot();
      ASSERT_GE(snapshot.tick, last);
      const std::vector<ModelState> models = snapshot.models;
      ASSERT_EQ(models, snapshot.models);
    }
  };
  std::thread page([&] { read(page_.reader); }), observers([&] { read(observers_.reader); });
  for (std::uint64_t tick = 0; tick < kTicks; ++tick) show();
  page.join();
  observers.join();
}

}  // namespace
}  // namespace playhouse::replicate
