#include "playhouse/server/outbox.h"

#include <gtest/gtest.h>

#include "playhouse/base/limits.h"

namespace playhouse::server {
namespace {

std::vector<device::Publication> data(double time, std::size_t bytes) {
  std::vector<device::Publication> batch;
  batch.push_back({{0}, 1, time, std::vector<std::byte>(bytes)});
  return batch;
}

TEST(Outbox, wakes_the_io_thread_once_until_it_comes) {
  Outbox outbox;
  EXPECT_FALSE(outbox.put(std::vector<device::Publication>()));
  EXPECT_TRUE(outbox.put(data(1, 10)));
  EXPECT_FALSE(outbox.put(data(2, 10)));
  EXPECT_FALSE(outbox.put(Answer{7, true, {}}));
  EXPECT_EQ(outbox.take_all().size(), 3u);
  EXPECT_TRUE(outbox.put(Answer{8, true, {}}));
}

TEST(Outbox, gives_up_old_data_for_new_over_the_limit_and_answers_never) {
  constexpr std::size_t kThird = limits::kOutboxBytes / 3;
  Outbox outbox;
  EXPECT_TRUE(outbox.put(data(1, kThird)));
  EXPECT_FALSE(outbox.put(Answer{7, true, std::vector<std::byte>(kThird)}));
  EXPECT_FALSE(outbox.put(data(2, kThird)));
  EXPECT_EQ(outbox.data_dropped(), 0u);
  EXPECT_FALSE(outbox.put(data(3, kThird)));
  EXPECT_EQ(outbox.data_dropped(), 2u);
  const std::vector<Outbox::Item> left = outbox.take_all();
  ASSERT_EQ(left.size(), 2u);
  EXPECT_EQ(std::get<Answer>(left[0]).ticket, 7u);
  EXPECT_EQ(std::get<device::Publication>(left[1]).timestamp, 3);
}

TEST(Outbox, lets_one_batch_through_whatever_its_size) {
  Outbox outbox;
  EXPECT_TRUE(outbox.put(data(1, limits::kOutboxBytes + 1)));
  EXPECT_EQ(outbox.take_all().size(), 1u);
  EXPECT_EQ(outbox.data_dropped(), 0u);
}

}  // namespace
}  // namespace playhouse::server
