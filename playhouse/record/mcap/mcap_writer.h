#pragma once

/// McapWriter: writes an MCAP file: zstd-compressed chunks, each followed by its message
/// index, and by filler if readers would not unpack as much of so small a file (UnpackedRoom); at the end a
/// summary for random access. Before that the file contains all flushed chunks, readable sequentially. Memory
/// does not grow with the length of the file: the summary is built from chunk headers read back from the
/// file. Thread: one.

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "playhouse/base/result.h"
#include "playhouse/record/mcap/mcap.h"
#include "playhouse/record/mcap/record_sink.h"

namespace playhouse::record {

class McapWriter final : public RecordSink {
 public:
  /// Creates or truncates the file. Errors include its name.
  static Result<std::unique_ptr<McapWriter>> create(const std::string& path, const std::string& profile,
                                                    const UnpackedRoom& room = {});
  ~McapWriter() override;
  McapWriter(const McapWriter&) = delete;
  McapWriter& operator=(const McapWriter&) = delete;

  void add(std::span<const std::byte> records) override;
  /// Uncompressed size.
  std::size_t waiting() const override { return chunk_.size(); }
  /// After a failure the file ends with the last complete chunk.
  Result<void> flush() override;
  Result<void> attach(const Attachment& attachment) override;
  /// Writes the summary.
  Result<void> finish() override;

 private:
  struct MessageIndexEntry {
    std::uint64_t time = 0, offset = 0;
  };
  struct AttachmentEntry {
    std::uint64_t offset = 0, length = 0, time = 0, data_size = 0;
    std::string name, media_type;
  };
  struct Written;  // a chunk of the file

  McapWriter(std::string path, int file, const UnpackedRoom& room);
  Result<void> write(std::span<const std::byte> bytes);
  Result<void> write_summary();
  Result<std::uint64_t> write_chunk_indices();
  Result<bool> read_chunk(std::uint64_t& offset, Written& chunk) const;
  bool read_at(std::uint64_t offset, std::span<std::byte> out) const;
  Bytes statistics(std::uint64_t chunks) const;
  Result<void> empty();
  Error fault(int code) const;

  const std::string path_;
  const int file_;
  const UnpackedRoom room_;
  std::uint64_t size_ = 0;      // of complete writes
  std::uint64_t unpacked_ = 0;  // bytes of all chunks
  bool failed_ = false;

  Bytes chunk_;                                                    // buffered records
  std::map<std::uint16_t, std::vector<MessageIndexEntry>> index_;  // of their messages
  std::uint64_t chunk_from_ = 0, chunk_to_ = 0;                    // their times [ns]

  // For the summary.
  Bytes schemas_, channels_;  // records
  std::vector<AttachmentEntry> attachments_;
  std::map<std::uint16_t, std::uint64_t> counts_;  // messages by channel
  std::uint64_t messages_ = 0, from_ = 0, to_ = 0;
  std::uint16_t schema_count_ = 0;
  std::uint32_t channel_count_ = 0;
};

}  // namespace playhouse::record
