#pragma once

/// Reader: decodes the XDR bytes of a message body: big-endian, 4-byte aligned (docs/wire.md).
/// The error is sticky: later reads give zeros, so that a decoder checks ok() once at its end.
/// Allocations are bounded by the available bytes, whatever counts claim. Value type; one thread.

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace playhouse::wire {

class Reader {
 public:
  /// Borrows `bytes` for its lifetime.
  explicit Reader(std::span<const std::byte> bytes) : bytes_(bytes) {}

  bool ok() const { return error_.empty(); }
  /// The error with its offset in the body; "" while ok().
  const std::string& error() const { return error_; }
  std::size_t offset() const { return offset_; }
  std::size_t remaining() const { return bytes_.size() - offset_; }

  void read(char& value) { value = static_cast<char>(word()); }
  void read(std::int8_t& value) { value = static_cast<std::int8_t>(word()); }
  void read(std::uint8_t& value) { value = static_cast<std::uint8_t>(word()); }
  void read(std::int16_t& value) { value = static_cast<std::int16_t>(word()); }
  void read(std::uint16_t& value) { value = static_cast<std::uint16_t>(word()); }
  void read(std::int32_t& value) { value = static_cast<std::int32_t>(word()); }
  void read(std::uint32_t& value) { value = word(); }
  void read(std::int64_t& value) { value = static_cast<std::int64_t>(double_word()); }
  void read(float& value);
  void read(double& value);

  /// Reads the length word of a dynamic array: at most `count`, the preceding count word, and
  /// at most what the remaining bytes can hold. 0 after an error. `name` is for the error.
  std::size_t dynamic_length(std::string_view name, std::uint32_t count, std::size_t element_bytes);
  /// The same for an array of at most `max` elements, regardless of the count word.
  std::size_t counted_length(std::string_view name, std::uint32_t max, std::size_t element_bytes);

  /// Reads `length` numbers, as validated by a length function above.
  template <typename Number>
  void read_numbers(std::vector<Number>& out, std::size_t length) {
    out.resize(length);
    for (Number& number : out) read(number);
  }

  /// Reads bytes of known length, and their pad to a multiple of four.
  void read_bytes(std::string& out, std::size_t length);
  void read_bytes(std::vector<std::uint8_t>& out, std::size_t length);
  void read_bytes(std::vector<std::int8_t>& out, std::size_t length);

  /// Sets the error if there is none.
  void fail(std::string_view what);

 private:
  std::uint32_t word();
  std::uint64_t double_word();
  std::span<const std::byte> take(std::size_t size);
  std::size_t length_within(std::string_view name, std::uint32_t bound, std::string_view bound_name,
                            std::size_t element_bytes);
  template <typename Container>
  void copy_bytes(Container& out, std::size_t length);

  std::span<const std::byte> bytes_;
  std::size_t offset_ = 0;
  std::string error_;
};

}  // namespace playhouse::wire
