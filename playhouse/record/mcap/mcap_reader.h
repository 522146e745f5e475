#pragma once

/// McapReader: streams through an MCAP file from the front, without its summary: a truncated file
/// is readable up to its last complete chunk. Every length is checked against the available bytes
/// and base/limits.h before allocating, and all that chunks unpack to against the size of the file
/// (UnpackedRoom). Supports zstd and uncompressed chunks. Thread: one.

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <string>

#include "playhouse/base/result.h"
#include "playhouse/record/mcap/mcap.h"

namespace playhouse::record {

/// Random access to the bytes of a file.
class ByteSource {
 public:
  virtual ~ByteSource() = default;
  virtual std::uint64_t size() const = 0;
  /// False on a read error.
  virtual bool read_at(std::uint64_t offset, std::span<std::byte> out) const = 0;
};

/// Errors include the file name.
Result<std::unique_ptr<ByteSource>> open_source(const std::string& path);

class McapReader {
 public:
  /// Callbacks in file order; an error aborts reading and is returned.
  struct McapListener {
    std::function<Result<void>(const Channel&, const MessageRecord&)> message = {};
    std::function<Result<void>(const Attachment&)> attachment = {};
  };
  /// Whether the file ends properly or is truncated.
  enum class FileEnd : std::uint8_t { kWhole, kCut };

  /// The source must outlive the reader.
  explicit McapReader(const ByteSource& source, const UnpackedRoom& room = {})
      : source_(&source), room_(room) {}

  /// Reads everything. Fails, without a file name, on data that
  /// is not MCAP or damaged, and at limits; not on truncation.
  Result<FileEnd> read(const McapListener& listener);

  /// Read so far.
  const std::map<std::uint16_t, Channel>& channels() const { return channels_; }
  const std::map<std::uint16_t, Schema>& schemas() const { return schemas_; }

 private:
  Result<void> take(Op op, std::span<const std::byte> content, const McapListener& listener);
  Result<void> take_chunk(std::span<const std::byte> content, const McapListener& listener);
  Result<void> take_schema(std::span<const std::byte> content);
  Result<void> take_channel(std::span<const std::byte> content);
  Result<void> take_message(std::span<const std::byte> content, const McapListener& listener);
  Result<void> take_attachment(std::span<const std::byte> content, const McapListener& listener);
  Error damaged(const std::string& what) const;

  const ByteSource* source_;
  UnpackedRoom room_;
  std::uint64_t at_ = 0;        // offset of the current record
  std::uint64_t unpacked_ = 0;  // bytes of all chunks so far
  std::map<std::uint16_t, Schema> schemas_;
  std::map<std::uint16_t, Channel> channels_;
};

}  // namespace playhouse::record
