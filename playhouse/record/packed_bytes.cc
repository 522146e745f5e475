#include "playhouse/record/packed_bytes.h"

#include <zstd.h>

#include "playhouse/base/assert.h"

namespace playhouse::record {

Bytes packed(std::span<const std::byte> bytes) {
  constexpr int kLevel = 1;
  Bytes out(ZSTD_compressBound(bytes.size()));
  const std::size_t size = ZSTD_compress(out.data(), out.size(), bytes.data(), bytes.size(), kLevel);
  PLAYHOUSE_ASSERT(ZSTD_isError(size) == 0);
  out.resize(size);
  return out;
}

PackedBytes::PackedBytes(std::span<const std::byte> bytes) : size_(bytes.size()) {
  if (bytes.empty()) return;
  packed_ = packed(bytes);
  packed_.shrink_to_fit();
}

Bytes PackedBytes::unpacked() const {
  Bytes bytes(size_);
  if (bytes.empty()) return bytes;
  const std::size_t got = ZSTD_decompress(bytes.data(), bytes.size(), packed_.data(), packed_.size());
  PLAYHOUSE_ASSERT(ZSTD_isError(got) == 0 && got == size_);
  return bytes;
}

}  // namespace playhouse::record
