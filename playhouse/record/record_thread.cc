#include "playhouse/record/record_thread.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "playhouse/base/log_at.h"
#include "playhouse/base/monotonic.h"

namespace playhouse::record {
namespace {

/// Maximum age of an unwritten chunk; with I/O well below a second. [s]
constexpr double kChunkTime = 0.5;

}  // namespace

RecordThread::RecordThread(std::unique_ptr<RecordSink> sink, std::size_t most_bytes)
    : sink_(std::move(sink)), most_bytes_(most_bytes) {}

RecordThread::RecordThread(std::unique_ptr<RecordSink> sink, std::function<double()> clock)
    : sink_(std::move(sink)), most_bytes_(limits::kRecordQueueBytes), clock_(std::move(clock)) {}

void RecordThread::hand_over(Bytes records) {
  if (records.empty()) return;
  wait_for_room();
  {
    const std::lock_guard lock(mutex_);
    if (failed_) return;
    waiting_bytes_ += records.size();
    waiting_.push_back(std::move(records));
  }
  if (clock_) return write_due();
  changed_.notify_all();
  if (!thread_.joinable()) thread_ = std::thread([this] { run(); });
}

void RecordThread::write_due() {
  if (failed_) return;
  take(std::exchange(waiting_, {}), clock_());
}

void RecordThread::wait_for_room() {
  const auto has_room = [this] { return failed_ || waiting_bytes_ < most_bytes_; };
  std::unique_lock lock(mutex_);
  if (has_room()) return;
  if (!std::exchange(told_slow_, true)) {
    lock.unlock();
    log::warn("the disk is slower than the run: the run waits for its recording");
    lock.lock();
  }
  changed_.wait(lock, has_room);
}

bool RecordThread::finish() {
  if (std::exchange(finished_, true)) return !failed_;
  {
    const std::lock_guard lock(mutex_);
    ending_ = true;
  }
  changed_.notify_all();
  if (thread_.joinable()) {
    thread_.join();
  } else {
    write(WriteEnd::kFile);
  }
  return !failed_;
}

void RecordThread::write(WriteEnd end) {
  const Result<void> written = end == WriteEnd::kFile ? sink_->finish() : sink_->flush();
  if (written) return;
  {
    const std::lock_guard lock(mutex_);
    if (std::exchange(failed_, true)) return;
  }
  changed_.notify_all();
  log::error_at(written.error().where, "{}; the run goes on and is recorded no more", written.error().text);
}

void RecordThread::pass_on(const Bytes& records) {
  sink_->add(records);
  if (sink_->waiting() >= chunk_bytes_) {
    write(WriteEnd::kChunk);
    chunk_bytes_ = std::min(2 * chunk_bytes_, limits::kRecordChunkBytes);
  }
  {
    const std::lock_guard lock(mutex_);
    waiting_bytes_ -= records.size();
  }
  changed_.notify_all();
}

/// Of who writes. A chunk that has become as old as it may is written.
void RecordThread::take(const std::deque<Bytes>& records, double now) {
  if (sink_->waiting() == 0 && !records.empty()) due_ = now + kChunkTime;
  for (const Bytes& each : records) pass_on(each);
  if (now < due_ || sink_->waiting() == 0) return;
  write(WriteEnd::kChunk);
  due_ = now + kChunkTime;
}

void RecordThread::run() {
  for (;;) {
    std::deque<Bytes> records;
    bool last = false;
    {
      std::unique_lock lock(mutex_);
      const auto wake = [this] { return ending_ || !waiting_.empty(); };
      if (sink_->waiting() == 0) {
        changed_.wait(lock, wake);
      } else {
        changed_.wait_for(lock, std::chrono::duration<double>(due_ - monotonic_seconds()), wake);
      }
      records.swap(waiting_);
      last = ending_;
    }
    take(records, monotonic_seconds());
    if (last) return write(WriteEnd::kFile);
  }
}

}  // namespace playhouse::record
