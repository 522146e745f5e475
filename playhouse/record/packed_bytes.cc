#include "playhouse/record/packed_bytes.h"

#include <zstd.h>

#include "playhouse/base/assert.h"

namespace playhouse::record {
namespace {

constexpr int kFastest = 1;

}  // namespace

PackedBytes::PackedBytes(std::span<const std::byte> bytes) : size_(bytes.size()) {
  if (bytes.empty()) return;
  Bytes room(ZSTD_compressBound(bytes.size()));
  const std::size_t size = ZSTD_compress(room.data(), room.size(), bytes.data(), bytes.size(), kFastest);
  PLAYHOUSE_ASSERT(ZSTD_isError(size) == 0);
  packed_.assign(room.begin(), room.begin() + static_cast<std::ptrdiff_t>(size));
}

Bytes PackedBytes::unpacked() const {
  Bytes bytes(size_);
  if (bytes.empty()) return bytes;
  const std::size_t got = ZSTD_decompress(bytes.data(), bytes.size(), packed_.data(), packed_.size());
  PLAYHOUSE_ASSERT(ZSTD_isError(got) == 0 && got == size_);
  return bytes;
}

}  // namespace playhouse::record
