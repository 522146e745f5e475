#pragma once

/// RecordSink: where the records of a recording go, in chunks. McapWriter is the file; a test has a disk of
/// its own. Thread: one.

#include <cstddef>
#include <span>

#include "playhouse/base/result.h"
#include "playhouse/record/mcap.h"

namespace playhouse::record {

class RecordSink {
 public:
  virtual ~RecordSink() = default;

  /// Whole records, as the functions put() of mcap.h make them; a schema before its channels, a channel
  /// before its messages. They are written with the next flush().
  virtual void add(std::span<const std::byte> records) = 0;
  /// Bytes that the next flush() would write.
  virtual std::size_t waiting() const = 0;
  /// Writes what waits as a chunk. May wait for a disk. After a failure every further call fails.
  virtual Result<void> flush() = 0;
  /// Writes an Attachment record, whole; what waits is flushed before it.
  virtual Result<void> attach(const Attachment& attachment) = 0;
  /// Flushes and writes the end. Nothing may follow.
  virtual Result<void> finish() = 0;
};

}  // namespace playhouse::record
