#pragma once

/// Numbers in frames of hardware, of either order of bytes. Values.

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace playhouse::drivers {

using RawBytes = std::vector<std::byte>;

/// `at` and what follows lie within `bytes`, as callers have checked.
inline std::uint8_t u8(std::span<const std::byte> bytes, std::size_t at) {
  return static_cast<std::uint8_t>(bytes[at]);
}
inline std::uint16_t u16_le(std::span<const std::byte> bytes, std::size_t at) {
  return static_cast<std::uint16_t>(u8(bytes, at) | u8(bytes, at + 1) << 8);
}
inline std::uint16_t u16_be(std::span<const std::byte> bytes, std::size_t at) {
  return static_cast<std::uint16_t>(u8(bytes, at) << 8 | u8(bytes, at + 1));
}
inline std::int16_t s16_le(std::span<const std::byte> bytes, std::size_t at) {
  return static_cast<std::int16_t>(u16_le(bytes, at));
}
inline std::int16_t s16_be(std::span<const std::byte> bytes, std::size_t at) {
  return static_cast<std::int16_t>(u16_be(bytes, at));
}
inline std::uint32_t u32_le(std::span<const std::byte> bytes, std::size_t at) {
  return u16_le(bytes, at) | static_cast<std::uint32_t>(u16_le(bytes, at + 2)) << 16;
}
inline std::uint32_t u32_be(std::span<const std::byte> bytes, std::size_t at) {
  return static_cast<std::uint32_t>(u16_be(bytes, at)) << 16 | u16_be(bytes, at + 2);
}

/// The low bits of a number of either sign, which is what two's complement sends.
inline void put_u8(RawBytes& bytes, int value) {
  bytes.push_back(static_cast<std::byte>(value));
}
inline void put_16_le(RawBytes& bytes, int value) {
  put_u8(bytes, value & 0xFF);
  put_u8(bytes, value >> 8 & 0xFF);
}
inline void put_16_be(RawBytes& bytes, int value) {
  put_u8(bytes, value >> 8 & 0xFF);
  put_u8(bytes, value & 0xFF);
}
inline void put_text(RawBytes& bytes, std::string_view text) {
  for (const char letter : text) bytes.push_back(static_cast<std::byte>(letter));
}

}  // namespace playhouse::drivers
