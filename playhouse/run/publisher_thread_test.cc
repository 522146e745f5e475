// Which parts are done, by when. Out of scope here: what becomes of a tick's data (simulation_test.cc).

#include "playhouse/run/publisher_thread.h"

#include <gtest/gtest.h>

#include <atomic>
#include <numeric>

namespace playhouse::run {
namespace {

/// Notes how often each part was done.
struct Counted {
  explicit Counted(std::size_t parts) : times(parts) {}
  Work work() {
    return {.parts = times.size(),
            .run = [this](std::size_t part) { ++times[part]; },
            .end =
                [this] {
                  ++ends;
                  done_at_end = std::accumulate(times.begin(), times.end(), 0);
                }};
  }
  std::vector<int> times;
  int done_at_end = 0, ends = 0;
};

TEST(PublisherThread, does_each_part_once_and_the_end_behind_all_for_any_number_of_workers) {
  for (const unsigned count : {1u, 3u}) {
    world::Workers workers(count);
    PublisherThread thread;
    for (int tick = 0; tick < 200; ++tick) {
      Counted many(50), one(1);
      const std::vector<Work> works{many.work(), one.work()};
      thread.begin(works);
      EXPECT_TRUE(thread.under_way());
      thread.finish(workers);
      EXPECT_FALSE(thread.under_way());
      EXPECT_EQ(many.times, std::vector<int>(50, 1));
      EXPECT_EQ(many.done_at_end, 50);
      EXPECT_EQ(one.times, std::vector<int>(1, 1));
      EXPECT_EQ(many.ends, 1);
      EXPECT_EQ(one.ends, 1);
    }
  }
}

TEST(PublisherThread, does_what_was_begun_while_nobody_asks_for_the_end) {
  world::Workers workers(1);
  PublisherThread thread;
  std::atomic<bool> done = false;
  const std::vector<Work> works{{.run = [&](std::size_t) { done = true; }}};
  thread.begin(works);
  thread.go_on();
  while (!done) std::this_thread::yield();
  EXPECT_TRUE(thread.under_way()) << "until finish()";
  thread.finish(workers);
  EXPECT_FALSE(thread.under_way());
}

TEST(PublisherThread, finishes_at_once_where_nothing_was_begun) {
  world::Workers workers(2);
  PublisherThread thread;
  thread.finish(workers);
  EXPECT_FALSE(thread.under_way());
}

}  // namespace
}  // namespace playhouse::run
