#pragma once

#include <compare>
#include <cstdint>

namespace playhouse::world {

/// Identity of a model for the life of a run: its serial number, given when it comes into being and to no
/// other model after it is gone. The same on any number of workers and after save and restore. Whoever names
/// a model outside the tick (devices, viewers, streams of random numbers, recordings, logs) names it so: rows
/// change as models come and go. The default is "none".
struct ModelId {
  static constexpr std::uint32_t kNone = 0xFFFFFFFFu;
  std::uint32_t value = kNone;

  constexpr bool valid() const { return value != kNone; }
  constexpr explicit operator bool() const { return valid(); }
  constexpr auto operator<=>(const ModelId&) const = default;
};

}  // namespace playhouse::world
