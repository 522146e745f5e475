#pragma once

/// PackedBytes: bytes that are kept compressed (zstd), unless they are few. The states of a recording are
/// much alike: a small file would fill the memory with them.

#include <cstddef>
#include <span>

#include "playhouse/record/mcap/mcap.h"

namespace playhouse::record {

/// Compressed by the fastest level: trade-off in docs/recording.md.
Bytes packed(std::span<const std::byte> bytes);

class PackedBytes {
 public:
  PackedBytes() = default;
  explicit PackedBytes(std::span<const std::byte> bytes);

  /// True if there are no bytes.
  bool empty() const { return size_ == 0; }
  /// Memory that they take. [B]
  std::size_t packed_size() const { return packed_.size(); }
  Bytes unpacked() const;

 private:
  Bytes packed_;
  std::size_t size_ = 0;
};

}  // namespace playhouse::record
