#include "playhouse/drivers/plugin/plugin_thread.h"

#include <gtest/gtest.h>

#include <atomic>
#include <future>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "playhouse/base/limits.h"

namespace playhouse::drivers {
namespace {

double no_time() {
  return 0;
}

TEST(PluginThread, runs_hooks_in_order_on_a_thread_of_its_own) {
  std::vector<int> order;
  std::promise<std::thread::id> last;
  PluginThread thread(PluginThread::Hooks::kOnThread, no_time, [](const std::string&) {});
  for (int k = 0; k < 100; ++k) EXPECT_TRUE(thread.post([&order, k] { order.push_back(k); }));
  EXPECT_TRUE(thread.post([&last] { last.set_value(std::this_thread::get_id()); }));
  EXPECT_NE(last.get_future().get(), std::this_thread::get_id());
  ASSERT_EQ(order.size(), 100u);
  for (int k = 0; k < 100; ++k) EXPECT_EQ(order[static_cast<std::size_t>(k)], k);
}

TEST(PluginThread, says_how_long_a_hook_has_been_running_and_takes_no_more_than_its_queue) {
  std::atomic<double> now = 10;
  std::promise<void> begun, go;
  PluginThread thread(
      PluginThread::Hooks::kOnThread, [&now] { return now.load(); }, [](const std::string&) {});
  EXPECT_EQ(thread.busy(), 0);
  thread.post([&] {
    begun.set_value();
    go.get_future().wait();
  });
  begun.get_future().wait();
  now = 13.5;
  EXPECT_EQ(thread.busy(), 3.5);
  for (std::size_t k = 0; k < limits::kPluginQueue; ++k) ASSERT_TRUE(thread.post([] {}));
  EXPECT_FALSE(thread.post([] {}));
  std::promise<void> last;
  thread.post_anyway([&last] { last.set_value(); });
  go.set_value();
  last.get_future().wait();
}

TEST(PluginThread, reports_what_a_hook_throws_and_drops_what_waits_once_it_has_ended) {
  std::promise<std::string> why;
  auto held = std::make_shared<int>(1);
  const std::weak_ptr<int> waits = held;
  PluginThread* self = nullptr;
  PluginThread thread(PluginThread::Hooks::kOnThread, no_time, [&](const std::string& text) {
    self->end();
    why.set_value(text);
  });
  self = &thread;
  std::promise<void> go;
  thread.post([&go] {
    go.get_future().wait();
    throw std::runtime_error("two\nlines");
  });
  thread.post([held = std::move(held)] {});
  go.set_value();
  EXPECT_EQ(why.get_future().get(), "two\\x0alines");
  EXPECT_TRUE(waits.expired());
  EXPECT_FALSE(thread.post([] {}));
}

TEST(PluginThread, ends_after_what_waits) {
  int done = 0;
  PluginThread thread(PluginThread::Hooks::kOnThread, no_time, [](const std::string&) {});
  for (int k = 0; k < 100; ++k) thread.post([&done] { ++done; });
  thread.finish();
  EXPECT_EQ(done, 100);
  EXPECT_FALSE(thread.post([] {}));
}

TEST(PluginThread, of_the_caller_leaves_a_hook_that_a_hook_posts_until_that_is_over) {
  std::string order;
  PluginThread thread(PluginThread::Hooks::kOnCaller, no_time, [](const std::string&) {});
  thread.post([&] {
    thread.post([&] { order += "second"; });
    order += "first ";
  });
  EXPECT_EQ(order, "first second");
}

}  // namespace
}  // namespace playhouse::drivers
