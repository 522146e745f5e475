#pragma once

/// Writer: encodes values as XDR, appended to the caller's vector (docs/wire.md). The only
/// error is an array over its bound: it is sticky, and the output is invalid then. One thread.

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace playhouse::wire {

class Writer {
 public:
  /// Appends to `out`, which must outlive the writer.
  explicit Writer(std::vector<std::byte>& out) : out_(&out) {}

  bool ok() const { return error_.empty(); }
  /// The array that is too long; "" while ok().
  const std::string& error() const { return error_; }

  void write(char value) {
    word(static_cast<std::uint32_t>(static_cast<std::int32_t>(static_cast<signed char>(value))));
  }
  void write(std::int8_t value) { word(static_cast<std::uint32_t>(static_cast<std::int32_t>(value))); }
  void write(std::uint8_t value) { word(value); }
  void write(std::int16_t value) { word(static_cast<std::uint32_t>(static_cast<std::int32_t>(value))); }
  void write(std::uint16_t value) { word(value); }
  void write(std::int32_t value) { word(static_cast<std::uint32_t>(value)); }
  void write(std::uint32_t value) { word(value); }
  void write(std::int64_t value) { double_word(static_cast<std::uint64_t>(value)); }
  void write(float value);
  void write(double value);

  /// Writes a count or length word; more than `max` elements is an error. `name` is for the error.
  void write_length(std::string_view name, std::size_t length, std::uint32_t max);

  template <typename Number>
  void write_numbers(const std::vector<Number>& numbers) {
    if constexpr (sizeof(Number) == 4 || sizeof(Number) == 8)
      write_together(std::as_bytes(std::span(numbers)), sizeof(Number));
    else
      for (const Number number : numbers) write(number);
  }

  /// Writes bytes, padded with zeros to a multiple of four.
  void write_bytes(std::span<const std::byte> bytes);
  /// Writes exactly `length` bytes plus the pad: short text is filled with zeros; longer text is an error.
  void write_fixed_text(std::string_view name, std::string_view text, std::size_t length);

 private:
  void word(std::uint32_t value);
  /// Bulk path for numbers of four or eight bytes in memory order.
  void write_together(std::span<const std::byte> numbers, std::size_t bytes_each);
  void double_word(std::uint64_t value);
  void fail_length(std::string_view name, std::size_t length, std::size_t max);

  std::vector<std::byte>* out_;
  std::string error_;
};

}  // namespace playhouse::wire
