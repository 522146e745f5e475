#include "playhouse/record/mcap/packed_bytes.h"

#include <zstd.h>

#include "playhouse/base/assert.h"

namespace playhouse::record {
namespace {

/// Fewer are kept as they are: the frame of zstd would take what it saves.
constexpr std::size_t kFew = 256;

}  // namespace

Bytes packed(std::span<const std::byte> bytes) {
  constexpr int kLevel = 1;
  Bytes out(ZSTD_compressBound(bytes.size()));
  const std::size_t size = ZSTD_compress(out.data(), out.size(), bytes.data(), bytes.size(), kLevel);
  PLAYHOUSE_ASSERT(ZSTD_isError(size) == 0);
  out.resize(size);
  return out;
}

PackedBytes::PackedBytes(std::span<const std::byte> bytes) : size_(bytes.size()) {
  packed_ = size_ < kFew ? Bytes(bytes.begin(), bytes.end()) : packed(bytes);
  packed_.shrink_to_fit();
}

Bytes PackedBytes::unpacked() const {
  if (size_ < kFew) return packed_;
  Bytes bytes(size_);
  const std::size_t got = ZSTD_decompress(bytes.data(), bytes.size(), packed_.data(), packed_.size());
  PLAYHOUSE_ASSERT(ZSTD_isError(got) == 0 && got == size_);
  return bytes;
}

}  // namespace playhouse::record
