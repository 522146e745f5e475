// Results come at their tick, whatever the threads do; without ticks they come when they are ready.

#include "playhouse/drivers/algorithm/algorithm_thread.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <future>
#include <thread>
#include <vector>

namespace playhouse::drivers {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

/// Appends `value` to `out` when its result is delivered.
AlgorithmThread::AlgorithmStep appends(std::vector<int>& out, int value) {
  return [&out, value](bool) { return [&out, value] { out.push_back(value); }; };
}

TEST(AlgorithmThread, a_result_is_due_so_many_ticks_after_its_step_was_posted) {
  std::vector<int> out;
  AlgorithmThread thread;
  thread.follow_ticks(0, 2);
  thread.post(appends(out, 1));  // in tick 1
  thread.ticked(1);
  thread.post(appends(out, 2));
  thread.ticked(2);
  EXPECT_THAT(out, IsEmpty()) << "ready long ago, but not due";
  thread.ticked(3);
  EXPECT_THAT(out, ElementsAre(1));
  thread.ticked(3);
  EXPECT_THAT(out, ElementsAre(1)) << "telling twice does no harm";
  thread.ticked(4);
  EXPECT_THAT(out, ElementsAre(1, 2));
}

TEST(AlgorithmThread, the_tick_waits_for_a_slow_step) {
  std::vector<int> out;
  AlgorithmThread thread;
  thread.follow_ticks(0, 0);
  thread.post([&out](bool) {
    for (int i = 0; i < 1000; ++i) std::this_thread::yield();  // time for a tick that does not wait
    return [&out] { out.push_back(1); };
  });
  thread.ticked(1);
  EXPECT_THAT(out, ElementsAre(1));
}

TEST(AlgorithmThread, results_are_delivered_on_the_thread_of_the_tick) {
  std::thread::id step, delivery;
  AlgorithmThread thread;
  thread.follow_ticks(0, 0);
  thread.post([&](bool) {
    step = std::this_thread::get_id();
    return [&] { delivery = std::this_thread::get_id(); };
  });
  thread.ticked(1);
  EXPECT_EQ(delivery, std::this_thread::get_id());
  EXPECT_NE(step, delivery);
}

TEST(AlgorithmThread, what_is_cleared_is_never_delivered_and_the_next_step_begins_afresh) {
  std::vector<int> out;
  std::vector<bool> fresh;
  AlgorithmThread thread;
  thread.follow_ticks(0, 0);
  const auto note = [&](int value) {
    return [&, value](bool is_fresh) {
      fresh.push_back(is_fresh);
      return [&, value] { out.push_back(value); };
    };
  };
  thread.post(note(1));
  thread.ticked(1);
  thread.post(note(2));
  thread.ticked(2);
  std::promise<void> begun, go;
  thread.post([&](bool) {
    begun.set_value();
    go.get_future().wait();
    return [&] { out.push_back(3); };
  });
  begun.get_future().wait();
  thread.clear();
  go.set_value();
  thread.post(note(4));
  thread.ticked(3);
  EXPECT_THAT(out, ElementsAre(1, 2, 4));
  EXPECT_THAT(fresh, ElementsAre(true, false, true));
}

TEST(AlgorithmThread, a_tick_that_waits_goes_on_when_its_step_is_cleared) {
  std::promise<void> begun, go;
  bool delivered = false;
  AlgorithmThread thread;
  thread.follow_ticks(0, 0);
  thread.post([&](bool) {
    begun.set_value();
    go.get_future().wait();
    return [&] { delivered = true; };
  });
  begun.get_future().wait();
  std::thread other([&] { thread.clear(); });
  thread.ticked(1);
  other.join();
  go.set_value();
  EXPECT_FALSE(delivered);
}

TEST(AlgorithmThread, without_ticks_a_newer_step_takes_the_place_of_one_that_waits) {
  std::promise<void> begun, go, done;
  std::vector<int> out;
  AlgorithmThread thread;
  thread.post([&](bool) {
    begun.set_value();
    go.get_future().wait();
    return [&] { out.push_back(1); };
  });
  begun.get_future().wait();
  thread.post(appends(out, 2));
  thread.post([&](bool) {
    return [&] {
      out.push_back(3);
      done.set_value();
    };
  });
  go.set_value();
  done.get_future().wait();
  EXPECT_THAT(out, ElementsAre(1, 3));
}

TEST(AlgorithmThread, ends_with_results_that_nobody_waits_for) {
  std::vector<int> out;
  {
    AlgorithmThread thread;
    thread.follow_ticks(0, 5);
    for (int i = 0; i < 3; ++i) thread.post(appends(out, i));
    thread.ticked(1);
  }
  EXPECT_THAT(out, IsEmpty());
}

// As in the simulation of the whole program.
TEST(AlgorithmThread, on_the_caller_a_step_runs_at_the_tick_that_its_result_is_due) {
  std::vector<int> out;
  std::vector<std::thread::id> threads;
  AlgorithmThread thread(AlgorithmThread::Steps::kOnCaller);
  thread.follow_ticks(0, 1);
  const auto step = [&](int value) {
    return [&, value](bool fresh) {
      threads.push_back(std::this_thread::get_id());
      return [&, value, fresh] { out.push_back(fresh ? -value : value); };
    };
  };
  thread.post(step(1));
  thread.ticked(1);
  EXPECT_THAT(threads, IsEmpty());
  thread.post(step(2));
  thread.ticked(2);
  EXPECT_THAT(out, ElementsAre(-1));
  thread.clear();
  thread.post(step(3));
  thread.ticked(4);
  EXPECT_THAT(out, ElementsAre(-1, -3));
  EXPECT_THAT(threads, ElementsAre(std::this_thread::get_id(), std::this_thread::get_id()));
}

TEST(AlgorithmThread, on_the_caller_without_ticks_what_a_delivery_posts_runs_after_it) {
  std::vector<int> out;
  AlgorithmThread thread(AlgorithmThread::Steps::kOnCaller);
  thread.post([&](bool) {
    return [&] {
      thread.post(appends(out, 2));
      out.push_back(1);
    };
  });
  EXPECT_THAT(out, ElementsAre(1, 2));
}

// For the thread sanitizer, and for the promise of clear(): when it returns, no delivery that began before is
// still under way.
TEST(AlgorithmThread, clear_and_tick_meet_at_any_moment) {
  std::atomic<int> newest = 1, delivering = 0;
  std::atomic<bool> over = false;
  AlgorithmThread thread;
  thread.follow_ticks(0, 1);
  std::thread ticks([&] {
    for (std::uint64_t tick = 1; tick <= 500; ++tick) {
      thread.post([&, number = newest.load()](bool) {
        return [&, number] {
          if (number != newest) return;
          delivering = number;
          std::this_thread::yield();
          delivering = 0;
        };
      });
      thread.ticked(tick);
    }
    over = true;
  });
  while (!over) {
    const int old = newest++;
    thread.clear();
    EXPECT_NE(delivering, old);
  }
  ticks.join();
}

}  // namespace
}  // namespace playhouse::drivers
