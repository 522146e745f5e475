// Batches pass readers in order, once each, with what the readers before made of them.

#include "playhouse/device/data_flow.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <future>
#include <thread>

#include "playhouse/device/fake_device.h"

namespace playhouse::device {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

Publication publication(std::uint32_t device, std::string_view body) {
  return {DeviceId{device}, 1, 0, bytes(body)};
}

/// Makes one message of its device from each batch: everything that it read, in brackets.
struct Joiner final : DataFlow::DataReader {
  explicit Joiner(std::uint32_t device) : device(device) {}
  std::uint32_t device;
  int calls = 0;
  void read(std::span<const Publication* const> fresh, std::vector<Publication>& more) override {
    ++calls;
    std::string all;
    for (const Publication* one : fresh) all += text(one->body);
    more.push_back(publication(device, "[" + all + "]"));
  }
};

TEST(DataFlow, a_reader_gets_what_the_readers_before_it_made) {
  FakePublisher out;
  DataFlow flow;
  flow.pass_to(out);
  Joiner first(1), second(2);
  flow.add(first, std::vector{DeviceId{0}});
  flow.add(second, std::vector{DeviceId{1}});
  flow.publish({publication(0, "a")});
  EXPECT_THAT(out.lines, ElementsAre("0.1 a", "1.1 [a]", "2.1 [[a]]"));
}

TEST(DataFlow, a_reader_of_two_devices_gets_both_at_once_in_the_order_of_the_batch) {
  FakePublisher out;
  DataFlow flow;
  flow.pass_to(out);
  Joiner converter(1), steering(3);
  flow.add(converter, std::vector{DeviceId{0}});
  flow.add(steering, std::vector{DeviceId{1}, DeviceId{2}});
  flow.publish({publication(0, "scan"), publication(2, "pose")});
  EXPECT_THAT(out.lines, ElementsAre("0.1 scan", "2.1 pose", "1.1 [scan]", "3.1 [pose[scan]]"));
  EXPECT_EQ(steering.calls, 1);
}

TEST(DataFlow, what_is_for_clients_alone_passes_the_readers_by) {
  FakePublisher out;
  DataFlow flow;
  Joiner reader(7);
  const DeviceId read[] = {{1}};
  flow.add(reader, read);
  flow.pass_to(out);
  flow.publish({{DeviceId{1}, 1, 0, bytes("a"), {3}},
                {DeviceId{1}, 1, 0, bytes("b"), {kDrivers, 3}},
                {DeviceId{1}, 1, 0, bytes("c")}});
  EXPECT_THAT(out.lines, ElementsAre("1.1 a", "1.1 b", "1.1 c", "7.1 [bc]"));
}

TEST(DataFlow, who_reads_nothing_of_a_batch_is_not_called) {
  FakePublisher out;
  DataFlow flow;
  flow.pass_to(out);
  Joiner reader(1);
  flow.add(reader, std::vector{DeviceId{7}});
  flow.publish({publication(0, "a"), publication(9, "b")});
  EXPECT_EQ(reader.calls, 0);
  EXPECT_THAT(out.lines, ElementsAre("0.1 a", "9.1 b"));
}

TEST(DataFlow, with_nowhere_to_go_data_still_reach_the_readers) {
  DataFlow flow;
  Joiner reader(1);
  flow.add(reader, std::vector{DeviceId{0}});
  flow.publish({publication(0, "a")});
  EXPECT_EQ(reader.calls, 1);
}

TEST(DataFlow, closes_once_what_is_being_published_is_and_drops_the_rest) {
  struct Slow final : Publisher {
    std::promise<void> begun, go;
    std::atomic<int> published = 0;
    void publish(std::vector<Publication>) override {
      begun.set_value();
      go.get_future().wait();
      ++published;
    }
  } out;
  DataFlow flow;
  flow.pass_to(out);
  std::thread driver([&flow] { flow.publish({publication(0, "a")}); });
  out.begun.get_future().wait();
  std::thread other([&out] { out.go.set_value(); });
  flow.close();
  EXPECT_EQ(out.published, 1);
  flow.publish({publication(0, "b")});
  EXPECT_EQ(out.published, 1);
  driver.join();
  other.join();
}

TEST(Subscription, keeps_the_newest_and_counts_what_gave_way) {
  Subscription queue(std::nullopt, 2);
  for (const char* body : {"a", "b", "c"}) queue.put(publication(0, body));
  EXPECT_EQ(queue.lost(), 1u);
  const std::vector<Publication> taken = queue.take();
  ASSERT_EQ(taken.size(), 2u);
  EXPECT_EQ(text(taken[0].body) + text(taken[1].body), "bc");
  EXPECT_THAT(queue.take(), IsEmpty());
  EXPECT_EQ(queue.lost(), 1u);
}

TEST(Subscription, of_one_subtype_has_no_other) {
  Subscription latest(2, 1);
  latest.put({DeviceId{0}, 1, 0, bytes("other")});
  EXPECT_FALSE(latest.take_latest());
  latest.put({DeviceId{0}, 2, 0, bytes("old")});
  latest.put({DeviceId{0}, 2, 0, bytes("new")});
  EXPECT_EQ(text(latest.take_latest()->body), "new");
  EXPECT_FALSE(latest.take_latest()) << "it has been taken";
  EXPECT_EQ(latest.lost(), 1u);
}

TEST(Subscription, the_latest_of_a_queue_leaves_the_older_ones_lost) {
  Subscription queue(std::nullopt, 3);
  for (const char* body : {"a", "b", "c"}) queue.put(publication(0, body));
  EXPECT_EQ(text(queue.take_latest()->body), "c");
  EXPECT_EQ(queue.lost(), 2u);
}

}  // namespace
}  // namespace playhouse::device
