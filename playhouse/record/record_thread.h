#pragma once

/// RecordThread: writes a recording in the background. The tick thread hands over records; a
/// thread compresses and writes them within half a second of wall time, which bounds the
/// loss if the program is killed. Back-pressure: if the disk is slower than the run, at most
/// limits::kRecordQueueBytes plus one hand-over are queued, then the run blocks; nothing is
/// dropped. On an I/O error the log says so once, the file ends there and the run continues.

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <utility>

#include "playhouse/base/limits.h"
#include "playhouse/record/mcap/record_sink.h"

namespace playhouse::record {

class RecordThread {
 public:
  explicit RecordThread(std::unique_ptr<RecordSink> sink, std::size_t most_bytes = limits::kRecordQueueBytes);
  /// Without a thread, as in a simulation of the whole program: hand_over() and write_due() write, by the
  /// monotonic seconds of `clock`.
  RecordThread(std::unique_ptr<RecordSink> sink, std::function<double()> clock);
  ~RecordThread() { finish(); }
  RecordThread(const RecordThread&) = delete;
  RecordThread& operator=(const RecordThread&) = delete;

  /// Queues records as for RecordSink::add(). May block on the disk. Tick thread.
  void hand_over(Bytes records);
  /// Without a thread: writes what is half a second old. Tick thread.
  void write_due();
  /// Writes an attachment synchronously, ahead of all
  /// records. Before the first hand_over(); tick thread.
  Result<void> attach(const Attachment& attachment) { return sink_->attach(attachment); }
  /// Flushes, ends the file and joins the thread. True if everything was written. Tick thread.
  bool finish();

 private:
  void wait_for_room();
  void run();
  void take(const std::deque<Bytes>& records, double now);
  void pass_on(const Bytes& records);
  enum class WriteEnd { kChunk, kFile };
  void write(WriteEnd end);

  const std::unique_ptr<RecordSink> sink_;  // used by the thread once that runs
  const std::size_t most_bytes_;
  const std::function<double()> clock_;  // s; empty: a thread writes
  double due_ = 0;                       // s; the chunk is written then; of who writes
  /// The next chunk's. The first ones are small: a disk that is full early has readable ones.
  std::size_t chunk_bytes_ = limits::kRecordChunkBytes / 16;

  std::mutex mutex_;  // guards what follows
  std::condition_variable changed_;
  std::deque<Bytes> waiting_;
  std::size_t waiting_bytes_ = 0;  // including those in work
  bool ending_ = false, failed_ = false, told_slow_ = false;

  bool finished_ = false;
  std::thread thread_;  // started by the first records, unless there is a clock
};

}  // namespace playhouse::record
