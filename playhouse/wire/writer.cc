#include "playhouse/wire/writer.h"

#include <array>
#include <bit>
#include <cstring>

namespace playhouse::wire {
namespace {

std::uint32_t turned(std::uint32_t word) {
  return __builtin_bswap32(word);
}
std::uint64_t turned(std::uint64_t word) {
  return __builtin_bswap64(word);
}

/// Copies words with byte order reversed to big-endian.
template <typename Word>
void copy_turned(std::span<const std::byte> from, std::byte* to) {
  for (std::size_t i = 0; i < from.size(); i += sizeof(Word)) {
    Word word = 0;
    std::memcpy(&word, from.data() + i, sizeof word);
    if constexpr (std::endian::native == std::endian::little) word = turned(word);
    std::memcpy(to + i, &word, sizeof word);
  }
}

}  // namespace

void Writer::word(std::uint32_t value) {
  const std::array<std::byte, 4> bytes = {
      static_cast<std::byte>(value >> 24), static_cast<std::byte>(value >> 16 & 0xFF),
      static_cast<std::byte>(value >> 8 & 0xFF), static_cast<std::byte>(value & 0xFF)};
  out_->insert(out_->end(), bytes.begin(), bytes.end());
}

void Writer::write_together(std::span<const std::byte> numbers, std::size_t bytes_each) {
  const std::size_t begin = out_->size();
  out_->resize(begin + numbers.size());
  if (bytes_each == 4)
    copy_turned<std::uint32_t>(numbers, out_->data() + begin);
  else
    copy_turned<std::uint64_t>(numbers, out_->data() + begin);
}

void Writer::double_word(std::uint64_t value) {
  word(static_cast<std::uint32_t>(value >> 32));
  word(static_cast<std::uint32_t>(value));
}

void Writer::write(float value) {
  word(std::bit_cast<std::uint32_t>(value));
}

void Writer::write(double value) {
  double_word(std::bit_cast<std::uint64_t>(value));
}

void Writer::write_length(std::string_view name, std::size_t length, std::uint32_t max) {
  if (length > max) fail_length(name, length, max);
  word(static_cast<std::uint32_t>(length));
}

void Writer::write_bytes(std::span<const std::byte> bytes) {
  out_->insert(out_->end(), bytes.begin(), bytes.end());
  out_->insert(out_->end(), (4 - bytes.size() % 4) % 4, std::byte{0});
}

void Writer::write_fixed_text(std::string_view name, std::string_view text, std::size_t length) {
  if (text.size() > length) {
    fail_length(name, text.size(), length);
    return;
  }
  const auto* first = reinterpret_cast<const std::byte*>(text.data());
  out_->insert(out_->end(), first, first + text.size());
  out_->insert(out_->end(), (length + 3) / 4 * 4 - text.size(), std::byte{0});
}

void Writer::fail_length(std::string_view name, std::size_t length, std::size_t max) {
  if (!ok()) return;
  error_ = std::string(name) + " has a length of " + std::to_string(length) + ", over its limit of " +
           std::to_string(max);
}

}  // namespace playhouse::wire
