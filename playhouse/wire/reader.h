#pragma once

/// Reader: XDR bytes of one message body to values, big-endian, everything a multiple of four bytes (docs/wire.md).
/// The first fault sticks: later reads give zeros and change nothing, so that a decoder checks ok() once, at its end.
/// Memory taken is bounded by the bytes that are there, whatever the counts in them claim. Value type; one thread.

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace playhouse::wire {

class Reader {
 public:
  /// Borrows `bytes` for its own life.
  explicit Reader(std::span<const std::byte> bytes) : bytes_(bytes) {}

  bool ok() const { return error_.empty(); }
  /// What is wrong and at which byte of the body; "" while ok().
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

  /// The length word of a dynamic array: at most `count`, the word that travelled before it, and no more than the
  /// bytes left can hold. 0 after a fault. `name` is for the error.
  std::size_t dynamic_length(std::string_view name, std::uint32_t count, std::size_t element_bytes);
  /// The same for an array of at most `max` elements; the count word does not bound it.
  std::size_t counted_length(std::string_view name, std::uint32_t max, std::size_t element_bytes);

  /// `length` numbers, which a length function above has allowed.
  template <typename Number>
  void read_numbers(std::vector<Number>& out, std::size_t length) {
    out.resize(length);
    for (Number& number : out) read(number);
  }

  /// Raw bytes of a known length, then the padding to four.
  void read_bytes(std::string& out, std::size_t length);
  void read_bytes(std::vector<std::uint8_t>& out, std::size_t length);
  void read_bytes(std::vector<std::int8_t>& out, std::size_t length);

  /// Sets the error, unless there is one.
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
