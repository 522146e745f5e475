#include "playhouse/record/record_thread.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "playhouse/base/log_at.h"

namespace playhouse::record {
namespace {

using Clock = std::chrono::steady_clock;

/// Maximum age of an unwritten chunk; with I/O well below a second.
constexpr std::chrono::milliseconds kChunkTime{500};

}  // namespace

RecordThread::RecordThread(std::unique_ptr<RecordSink> sink, std::size_t most_bytes)
    : sink_(std::move(sink)), most_bytes_(most_bytes) {}

void RecordThread::hand_over(Bytes records) {
  if (records.empty()) return;
  wait_for_room();
  {
    const std::lock_guard lock(mutex_);
    if (failed_) return;
    waiting_bytes_ += records.size();
    waiting_.push_back(std::move(records));
  }
  changed_.notify_all();
  if (!thread_.joinable()) thread_ = std::thread([this] { run(); });
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
    write(End::kFile);
  }
  return !failed_;
}

void RecordThread::write(End end) {
  const Result<void> written = end == End::kFile ? sink_->finish() : sink_->flush();
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
    write(End::kChunk);
    chunk_bytes_ = std::min(2 * chunk_bytes_, limits::kRecordChunkBytes);
  }
  {
    const std::lock_guard lock(mutex_);
    waiting_bytes_ -= records.size();
  }
  changed_.notify_all();
}

void RecordThread::run() {
  Clock::time_point due = Clock::now() + kChunkTime;
  for (;;) {
    std::deque<Bytes> records;
    bool last = false;
    {
      std::unique_lock lock(mutex_);
      changed_.wait_until(lock, due, [this] { return ending_ || !waiting_.empty(); });
      records.swap(waiting_);
      last = ending_;
    }
    if (sink_->waiting() == 0 && !records.empty()) due = Clock::now() + kChunkTime;
    for (const Bytes& each : records) pass_on(each);
    if (last) return write(End::kFile);
    if (Clock::now() < due) continue;
    write(End::kChunk);
    due = Clock::now() + kChunkTime;
  }
}

}  // namespace playhouse::record
