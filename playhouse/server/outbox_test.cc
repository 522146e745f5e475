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

std::vector<Outbox::OutboxItem> taken(Outbox& outbox) {
  std::vector<Outbox::OutboxItem> items;
  EXPECT_FALSE(outbox.take(items, SIZE_MAX));
  return items;
}

TEST(Outbox, wakes_the_io_thread_once_until_it_comes) {
  Outbox outbox;
  EXPECT_FALSE(outbox.put(std::vector<device::Publication>()));
  EXPECT_TRUE(outbox.put(data(1, 10)));
  EXPECT_FALSE(outbox.put(data(2, 10)));
  EXPECT_FALSE(outbox.put(Answer{7, true, {}}));
  EXPECT_EQ(taken(outbox).size(), 3u);
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
  const std::vector<Outbox::OutboxItem> left = taken(outbox);
  ASSERT_EQ(left.size(), 2u);
  EXPECT_EQ(std::get<Answer>(left[0]).ticket, 7u);
  EXPECT_EQ(std::get<device::Publication>(left[1]).timestamp, 3);
}

TEST(Outbox, tells_once_which_devices_lost_how_much) {
  Outbox outbox;
  std::vector<device::Publication> batch = data(1, 10);
  batch.push_back({{5}, 1, 1, {}});
  EXPECT_TRUE(outbox.put(std::move(batch)));
  EXPECT_FALSE(outbox.put(data(2, 10)));
  EXPECT_FALSE(outbox.put(data(3, limits::kOutboxBytes)));
  const std::map<device::DeviceId, std::uint64_t> lost{{{0}, 2}, {{5}, 1}};
  EXPECT_EQ(outbox.take_dropped(), lost);
  EXPECT_TRUE(outbox.take_dropped().empty());
}

TEST(Outbox, holds_so_many_messages_however_small) {
  Outbox outbox;
  for (std::size_t i = 0; i <= limits::kOutboxMessages; ++i) {
    const bool wakes = outbox.put(data(static_cast<double>(i), 0));
    EXPECT_EQ(wakes, i == 0);
  }
  EXPECT_EQ(outbox.data_dropped(), limits::kOutboxMessages);
  EXPECT_EQ(taken(outbox).size(), 1u);
}

TEST(Outbox, is_emptied_in_portions_by_one_who_comes_again_unwoken) {
  Outbox outbox;
  std::vector<Outbox::OutboxItem> items;
  EXPECT_TRUE(outbox.put(data(1, 10)));
  EXPECT_FALSE(outbox.put(Answer{7, true, {}}));
  EXPECT_TRUE(outbox.take(items, 1));
  ASSERT_EQ(items.size(), 1u);
  EXPECT_EQ(std::get<device::Publication>(items[0]).timestamp, 1);
  items.clear();
  EXPECT_FALSE(outbox.put(data(2, 10))) << "it comes anyway";
  EXPECT_FALSE(outbox.take(items, 2));
  ASSERT_EQ(items.size(), 2u);
  EXPECT_EQ(std::get<Answer>(items[0]).ticket, 7u);
  EXPECT_TRUE(outbox.put(data(3, limits::kOutboxBytes))) << "what was taken counts no longer";
  EXPECT_EQ(outbox.data_dropped(), 0u);
}

TEST(Outbox, lets_one_batch_through_whatever_its_size) {
  Outbox outbox;
  EXPECT_TRUE(outbox.put(data(1, limits::kOutboxBytes + 1)));
  EXPECT_EQ(taken(outbox).size(), 1u);
  EXPECT_EQ(outbox.data_dropped(), 0u);
}

}  // namespace
}  // namespace playhouse::server
