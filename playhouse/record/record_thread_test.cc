// A recording whose disk is slower than the run, or fails: a disk that writes when the test says so.

#include "playhouse/record/record_thread.h"

#include <gtest/gtest.h>

#include <atomic>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace playhouse::record {
namespace {

constexpr std::size_t kSize = 100;         // bytes of a hand-over
constexpr std::size_t kRoom = 10 * kSize;  // that may wait

/// What a disk does, for the thread that writes and the test.
struct Disk {
  std::mutex mutex;
  std::condition_variable changed;
  bool open = false;  // else whoever writes waits
  bool works = true;
  std::size_t written = 0;  // flushes of something: there is one without every second
  std::string records;      // the first byte of each, as they were added

  void let_write(bool well = true) {
    {
      const std::lock_guard lock(mutex);
      open = true;
      works = well;
    }
    changed.notify_all();
  }
  std::size_t flushes() {
    const std::lock_guard lock(mutex);
    return written;
  }
};

/// Every hand-over is a chunk of its own, unless it counts as fewer bytes.
class SlowSink final : public RecordSink {
 public:
  explicit SlowSink(Disk& disk, std::size_t bytes = limits::kRecordChunkBytes) : disk_(disk), bytes_(bytes) {}
  void add(std::span<const std::byte> records) override {
    const std::lock_guard lock(disk_.mutex);
    disk_.records += static_cast<char>(records[0]);
    waiting_ = bytes_;
  }
  std::size_t waiting() const override { return waiting_; }
  Result<void> flush() override {
    std::unique_lock lock(disk_.mutex);
    disk_.changed.wait(lock, [this] { return disk_.open; });
    const bool has_records = std::exchange(waiting_, 0) > 0;
    if (!disk_.works) return Error{"disk", "is full"};
    disk_.written += has_records;
    return {};
  }
  Result<void> attach(const Attachment&) override { return {}; }
  Result<void> finish() override { return waiting_ == 0 ? Result<void>() : flush(); }

 private:
  Disk& disk_;
  const std::size_t bytes_;
  std::size_t waiting_ = 0;
};

Bytes record(char first) {
  Bytes bytes(kSize);
  bytes[0] = static_cast<std::byte>(first);
  return bytes;
}

/// Hands over as much as there is room for, on a disk that writes nothing yet; returns what was handed over.
std::string fill(RecordThread& thread) {
  std::string all;
  for (char letter = 'a'; all.size() * kSize < kRoom; ++letter) {
    thread.hand_over(record(letter));
    all += letter;
  }
  return all;
}

/// Opens the disk once somebody is about to wait for it: `waits` may only go on then.
std::thread opener(Disk& disk, const std::atomic<bool>& about_to_wait, bool works) {
  return std::thread([&disk, &about_to_wait, works] {
    while (!about_to_wait) std::this_thread::yield();
    for (int i = 0; i < 1000; ++i) std::this_thread::yield();  // time for who should wait, and does not
    disk.let_write(works);
  });
}

TEST(RecordThread, takes_what_there_is_room_for_without_waiting_for_the_disk) {
  Disk disk;
  RecordThread thread(std::make_unique<SlowSink>(disk), kRoom);
  const std::string all = fill(thread);
  EXPECT_EQ(disk.flushes(), 0u);
  disk.let_write();
  EXPECT_TRUE(thread.finish());
  EXPECT_EQ(disk.records, all);
}

TEST(RecordThread, has_the_run_wait_for_a_slow_disk_and_leaves_nothing_out) {
  for (int round = 0; round < 20; ++round) {
    Disk disk;
    RecordThread thread(std::make_unique<SlowSink>(disk), kRoom);
    const std::string all = fill(thread);
    std::atomic<bool> about_to_wait = false;
    std::thread other = opener(disk, about_to_wait, true);
    about_to_wait = true;
    thread.hand_over(record('z'));
    EXPECT_GE(disk.flushes(), 1u) << "there was no room before the disk had written something";
    other.join();
    EXPECT_TRUE(thread.finish());
    EXPECT_EQ(disk.records, all + 'z') << "all, in their order";
    EXPECT_EQ(disk.flushes(), all.size() + 1);
  }
}

TEST(RecordThread, has_the_run_go_on_where_the_disk_fails_while_it_waits) {
  Disk disk;
  RecordThread thread(std::make_unique<SlowSink>(disk), kRoom);
  fill(thread);
  std::atomic<bool> about_to_wait = false;
  std::thread other = opener(disk, about_to_wait, false);
  about_to_wait = true;
  thread.hand_over(record('z'));
  other.join();
  for (int i = 0; i < 100; ++i) thread.hand_over(record('z'));  // far more than there is room for
  EXPECT_FALSE(thread.finish());
  EXPECT_EQ(disk.flushes(), 0u);
}

TEST(RecordThread, writes_by_its_clock_what_is_half_a_second_old_without_a_thread) {
  Disk disk;
  disk.let_write();
  double now = 7;
  RecordThread thread(std::make_unique<SlowSink>(disk, 1), [&now] { return now; });
  thread.hand_over(record('a'));
  now = 7.4;
  thread.hand_over(record('b'));
  thread.write_due();
  EXPECT_EQ(disk.flushes(), 0u);
  now = 7.5;
  thread.write_due();
  EXPECT_EQ(disk.flushes(), 1u);
  now = 9;
  thread.hand_over(record('c'));
  EXPECT_EQ(disk.flushes(), 1u) << "its half second begins with it";
  EXPECT_TRUE(thread.finish());
  EXPECT_EQ(disk.flushes(), 2u);
  EXPECT_EQ(disk.records, "abc");
}

}  // namespace
}  // namespace playhouse::record
