#pragma once

/// RecordThread: a recording on its way to the disk. The tick thread hands over records; a thread of its own
/// packs and writes them, at the latest half a second of wall time later, so that a program that is killed
/// loses no more than that. Where the disk is slower than the run, limits::kRecordQueueBytes and one
/// hand-over wait at most, and then the run does: nothing is left out. Where the disk fails, the log says so
/// once, the file ends with what was written and the run goes on.

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <utility>

#include "playhouse/base/limits.h"
#include "playhouse/record/record_sink.h"

namespace playhouse::record {

class RecordThread {
 public:
  explicit RecordThread(std::unique_ptr<RecordSink> sink, std::size_t most_bytes = limits::kRecordQueueBytes);
  ~RecordThread() { finish(); }
  RecordThread(const RecordThread&) = delete;
  RecordThread& operator=(const RecordThread&) = delete;

  /// Records as for RecordSink::add(). May wait for the disk. Tick thread.
  void hand_over(Bytes records);
  /// Goes to the file before everything that is handed over later, and is there when this returns. Before
  /// the first hand_over(); tick thread.
  Result<void> attach(const Attachment& attachment) { return sink_->attach(attachment); }
  /// Writes what waits and the file's end. True if all was written. Tick thread.
  bool finish();

 private:
  void wait_for_room();
  void run();
  void pass_on(const Bytes& records);
  enum class End { kChunk, kFile };
  void write(End end);

  const std::unique_ptr<RecordSink> sink_;  // the thread's, once that runs
  const std::size_t most_bytes_;

  std::mutex mutex_;  // guards what follows
  std::condition_variable changed_;
  std::deque<Bytes> waiting_;
  std::size_t waiting_bytes_ = 0;  // with those that the thread has and has not passed on
  bool ending_ = false, failed_ = false, told_slow_ = false;

  bool finished_ = false;
  std::thread thread_;  // from the first records on
};

}  // namespace playhouse::record
