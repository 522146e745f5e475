#pragma once

/// MemorySource: bytes in memory as a file, for tests and fuzzers.

#include <algorithm>
#include <span>

#include "playhouse/record/mcap/mcap_reader.h"

namespace playhouse::record {

class MemorySource final : public ByteSource {
 public:
  /// The bytes must outlive it.
  explicit MemorySource(std::span<const std::byte> bytes) : bytes_(bytes) {}
  std::uint64_t size() const override { return bytes_.size(); }
  bool read_at(std::uint64_t offset, std::span<std::byte> out) const override {
    if (offset > bytes_.size() || out.size() > bytes_.size() - offset) return false;
    std::ranges::copy(bytes_.subspan(static_cast<std::size_t>(offset), out.size()), out.begin());
    return true;
  }

 private:
  std::span<const std::byte> bytes_;
};

}  // namespace playhouse::record
