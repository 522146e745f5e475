#pragma once

/// McapReader: goes through an MCAP file from the front, which needs no summary: a file of a program that was
/// killed reads up to its last whole chunk. Every length is checked against what is there and against
/// base/limits.h before memory is taken. Reads chunks that are packed with zstd or not at all. Thread: one.

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <string>

#include "playhouse/base/result.h"
#include "playhouse/record/mcap.h"

namespace playhouse::record {

/// Where the bytes of a file come from.
class Source {
 public:
  virtual ~Source() = default;
  virtual std::uint64_t size() const = 0;
  /// False: they cannot be read.
  virtual bool read_at(std::uint64_t offset, std::span<std::byte> out) const = 0;
};

/// The error names the file.
Result<std::unique_ptr<Source>> open_source(const std::string& path);

class McapReader {
 public:
  /// Who hears of what is read, in the file's order; an error ends the reading, with that error.
  struct Listener {
    std::function<Result<void>(const Channel&, const Message&)> message = {};
    std::function<Result<void>(const Attachment&)> attachment = {};
  };
  /// Whether the file says that it ends.
  enum class End : std::uint8_t { kWhole, kCut };

  /// The source must outlive the reader.
  explicit McapReader(const Source& source) : source_(&source) {}

  /// Reads all. Fails, naming no file, on what is no MCAP, on damage, and where a limit is passed; on a file
  /// that is cut it does not.
  Result<End> read(const Listener& listener);

  /// Known so far.
  const std::map<std::uint16_t, Channel>& channels() const { return channels_; }
  const std::map<std::uint16_t, Schema>& schemas() const { return schemas_; }

 private:
  Result<void> take(Op op, std::span<const std::byte> content, const Listener& listener);
  Result<void> take_chunk(std::span<const std::byte> content, const Listener& listener);
  Result<void> take_schema(std::span<const std::byte> content);
  Result<void> take_channel(std::span<const std::byte> content);
  Result<void> take_message(std::span<const std::byte> content, const Listener& listener);
  Result<void> take_attachment(std::span<const std::byte> content, const Listener& listener);
  Error damaged(const std::string& what) const;

  const Source* source_;
  std::uint64_t at_ = 0;  // of the record that is read
  std::map<std::uint16_t, Schema> schemas_;
  std::map<std::uint16_t, Channel> channels_;
};

}  // namespace playhouse::record
