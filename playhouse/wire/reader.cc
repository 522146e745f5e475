#include "playhouse/wire/reader.h"

#include <bit>
#include <cstring>

namespace playhouse::wire {

namespace {

std::string plural(std::size_t n, std::string_view noun) {
  return std::to_string(n) + " " + std::string(noun) + (n == 1 ? "" : "s");
}

std::uint64_t big_endian(std::span<const std::byte> bytes) {
  std::uint64_t value = 0;
  for (const std::byte b : bytes) value = value << 8 | std::to_integer<std::uint64_t>(b);
  return value;
}

}  // namespace

void Reader::fail(std::string_view what) {
  if (!ok()) return;
  error_ =
      std::string(what) + ", at byte " + std::to_string(offset_) + " of " + std::to_string(bytes_.size());
  offset_ = bytes_.size();
}

std::span<const std::byte> Reader::take(std::size_t size) {
  if (!ok()) return {};
  if (size > remaining()) {
    fail(plural(size, "byte") + " wanted, " + std::to_string(remaining()) + " left");
    return {};
  }
  const auto taken = bytes_.subspan(offset_, size);
  offset_ += size;
  return taken;
}

std::uint32_t Reader::word() {
  return static_cast<std::uint32_t>(big_endian(take(4)));
}

std::uint64_t Reader::double_word() {
  return big_endian(take(8));
}

void Reader::read(float& value) {
  value = std::bit_cast<float>(word());
}

void Reader::read(double& value) {
  value = std::bit_cast<double>(double_word());
}

std::size_t Reader::length_within(std::string_view name, std::uint32_t bound, std::string_view bound_name,
                                  std::size_t element_bytes) {
  const std::uint32_t length = word();
  if (!ok()) return 0;
  if (length > bound) {
    fail(std::string(name) + " has a length of " + std::to_string(length) + ", over its " +
         std::string(bound_name) + " of " + std::to_string(bound));
    return 0;
  }
  if (length > remaining() / element_bytes) {
    fail(std::string(name) + " claims " + plural(length, "element") + ", but only " +
         plural(remaining(), "byte") + " are left");
    return 0;
  }
  return length;
}

std::size_t Reader::dynamic_length(std::string_view name, std::uint32_t count, std::size_t element_bytes) {
  return length_within(name, count, "count", element_bytes);
}

std::size_t Reader::counted_length(std::string_view name, std::uint32_t max, std::size_t element_bytes) {
  return length_within(name, max, "limit", element_bytes);
}

template <typename Container>
void Reader::copy_bytes(Container& out, std::size_t length) {
  out.clear();
  const auto bytes = take((length + 3) / 4 * 4);
  if (bytes.empty()) return;
  out.resize(length);
  std::memcpy(out.data(), bytes.data(), length);
}

void Reader::read_bytes(std::string& out, std::size_t length) {
  copy_bytes(out, length);
}
void Reader::read_bytes(std::vector<std::uint8_t>& out, std::size_t length) {
  copy_bytes(out, length);
}
void Reader::read_bytes(std::vector<std::int8_t>& out, std::size_t length) {
  copy_bytes(out, length);
}

}  // namespace playhouse::wire
