#pragma once

/// RecordSink: destination of a recording's records, in chunks.
/// McapWriter is the file; tests use a fake. Thread: one.

#include <cstddef>
#include <span>

#include "playhouse/base/result.h"
#include "playhouse/record/mcap/mcap.h"

namespace playhouse::record {

class RecordSink {
 public:
  virtual ~RecordSink() = default;

  /// Buffers whole records, as made by put() of mcap.h; schemas before their
  /// channels, channels before their messages. They are written by the next flush().
  virtual void add(std::span<const std::byte> records) = 0;
  /// Size of the buffered records.
  virtual std::size_t waiting() const = 0;
  /// Writes the buffer as a chunk. May block on I/O. After a failure all further calls fail.
  virtual Result<void> flush() = 0;
  /// Flushes, then writes an Attachment record.
  virtual Result<void> attach(const Attachment& attachment) = 0;
  /// Flushes and writes the end of the file. No calls may follow.
  virtual Result<void> finish() = 0;
};

}  // namespace playhouse::record
