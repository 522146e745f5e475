#pragma once

/// CDR serialisation of ROS 2 messages: little-endian numbers, aligned to their
/// size relative to the end of the four-byte header; strings and sequences with
/// a length prefix, strings with a NUL. Source: OMG DDSI-RTPS, plain CDR. Value.

#include <bit>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>

#include "playhouse/record/mcap/mcap.h"

namespace playhouse::record {

class CdrWriter {
 public:
  template <typename Number>
  void number(Number value) {
    static_assert(std::is_arithmetic_v<Number> && std::endian::native == std::endian::little);
    align(sizeof(Number));
    put_bytes(bytes_, std::as_bytes(std::span(&value, 1)));
  }
  void text(std::string_view value) {
    number(static_cast<std::uint32_t>(value.size() + 1));
    put_bytes(bytes_, std::as_bytes(std::span(value)));
    bytes_.push_back({});
  }
  /// Length prefix of a sequence.
  void count(std::size_t elements) { number(static_cast<std::uint32_t>(elements)); }
  void floats(std::span<const float> values) {
    count(values.size());
    put_bytes(bytes_, std::as_bytes(values));
  }
  /// An array of fixed length.
  void numbers(std::span<const double> values) {
    align(sizeof(double));
    put_bytes(bytes_, std::as_bytes(values));
  }
  void bytes(std::span<const std::byte> values) {
    count(values.size());
    put_bytes(bytes_, values);
  }
  /// builtin_interfaces/Time.
  void time(std::uint64_t ns) {
    number(static_cast<std::int32_t>(ns / 1'000'000'000));
    number(static_cast<std::uint32_t>(ns % 1'000'000'000));
  }
  const Bytes& message() const { return bytes_; }

 private:
  void align(std::size_t size) {
    while ((bytes_.size() - kHeadBytes) % size != 0) bytes_.push_back({});
  }
  static constexpr std::size_t kHeadBytes = 4;
  Bytes bytes_{std::byte{0}, std::byte{1}, std::byte{0}, std::byte{0}};
};

/// Deserialises CDR; the error is sticky, after it everything reads as zero.
class CdrReader {
 public:
  explicit CdrReader(std::span<const std::byte> message) : bytes_(message), at_(4) {
    ok_ = message.size() >= 4 && message[0] == std::byte{0} && message[1] == std::byte{1};
  }
  template <typename Number>
  Number number() {
    at_ += (sizeof(Number) - (at_ - 4) % sizeof(Number)) % sizeof(Number);
    Number value{};
    if (const auto from = take(sizeof(Number)); !from.empty()) std::memcpy(&value, from.data(), sizeof value);
    return value;
  }
  std::string text() {
    const auto size = number<std::uint32_t>();
    const std::span<const std::byte> from = take(size);
    ok_ = ok_ && size > 0;
    return ok_ ? std::string(reinterpret_cast<const char*>(from.data()), size - 1) : std::string();
  }
  std::span<const std::byte> bytes() { return take(number<std::uint32_t>()); }
  std::uint64_t time() {
    const auto seconds = number<std::int32_t>();
    const auto ns = number<std::uint32_t>();
    return static_cast<std::uint64_t>(seconds) * 1'000'000'000 + ns;
  }
  std::size_t left() const { return ok_ ? bytes_.size() - at_ : 0; }
  bool ok() const { return ok_; }

 private:
  std::span<const std::byte> take(std::size_t size) {
    ok_ = ok_ && at_ <= bytes_.size() && size <= bytes_.size() - at_;
    if (!ok_) return {};
    at_ += size;
    return bytes_.subspan(at_ - size, size);
  }
  std::span<const std::byte> bytes_;
  std::size_t at_;
  bool ok_;
};

}  // namespace playhouse::record
