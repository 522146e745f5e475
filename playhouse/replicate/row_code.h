#pragma once

/// Delta encoding of a model's state: only fields that differ from
/// a baseline held by the other end. Used by the packets of delta.h
/// and datagram.h; fields and mask bits are specified in delta.h.

#include <cstdint>
#include <limits>

#include "playhouse/base/packing.h"
#include "playhouse/replicate/layout.h"

namespace playhouse::replicate {

/// The mask of the fields that differ; 0: none.
inline std::uint8_t changed_fields(const ModelState& from, const ModelState& to) {
  return static_cast<std::uint8_t>(
      (from.x != to.x ? 1 : 0) | (from.y != to.y ? 2 : 0) | (from.z != to.z ? 4 : 0) |
      (from.a != to.a ? 8 : 0) | (from.state != to.state ? 16 : 0) | (from.color != to.color ? 32 : 0) |
      (from.flags != to.flags ? 64 : 0) | (from.tilt_x != to.tilt_x || from.tilt_y != to.tilt_y ? 128 : 0));
}

inline void write_fields(std::uint8_t mask, const ModelState& from, const ModelState& to, Packer& pack) {
  const auto difference = [&](std::int32_t before, std::int32_t now) {
    pack.zigzag(static_cast<std::int64_t>(now) - static_cast<std::int64_t>(before));
  };
  if (mask & 1) difference(from.x, to.x);
  if (mask & 2) difference(from.y, to.y);
  if (mask & 4) difference(from.z, to.z);
  if (mask & 8) pack.zigzag(static_cast<std::int16_t>(static_cast<std::uint16_t>(to.a - from.a)));
  if (mask & 16) pack.u8(to.state);
  if (mask & 32) pack.u32(to.color);
  if (mask & 64) pack.varint(to.flags);
  if (mask & 128) pack.u16(to.tilt_x), pack.u16(to.tilt_y);
}

/// Applies delta fields to `state`. False: a number
/// is out of range, and the state is unusable.
inline bool read_fields(std::uint8_t mask, Unpacker& in, ModelState& state) {
  bool fits = true;
  const auto add = [&](std::int32_t& value) {
    const std::int64_t sum = value + in.zigzag() % (std::int64_t{1} << 33);
    fits = fits && sum >= std::numeric_limits<std::int32_t>::min() &&
           sum <= std::numeric_limits<std::int32_t>::max();
    value = static_cast<std::int32_t>(sum & 0xFFFFFFFF);
  };
  if (mask & 1) add(state.x);
  if (mask & 2) add(state.y);
  if (mask & 4) add(state.z);
  if (mask & 8)
    state.a = static_cast<std::uint16_t>(state.a + static_cast<std::uint16_t>(in.zigzag() & 0xFFFF));
  if (mask & 16) state.state = in.u8();
  if (mask & 32) state.color = in.u32();
  if (mask & 64) state.flags = static_cast<std::uint32_t>(in.varint());
  if (mask & 128) {
    state.tilt_x = in.u16();
    state.tilt_y = in.u16();
  }
  return fits;
}

}  // namespace playhouse::replicate
