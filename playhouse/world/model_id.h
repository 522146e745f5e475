#pragma once

#include <compare>
#include <cstdint>

namespace playhouse::world {

/// Identity of a model in a run: a serial number assigned at creation and never reused.
/// Independent of the number of workers, preserved by save and restore. Everything
/// outside the tick (devices, viewers, random streams, recordings, logs) refers to models
/// by id, since rows change when models are spawned or removed. The default is "none".
struct ModelId {
  static constexpr std::uint32_t kNone = 0xFFFFFFFFu;
  std::uint32_t value = kNone;

  constexpr bool valid() const { return value != kNone; }
  constexpr explicit operator bool() const { return valid(); }
  constexpr auto operator<=>(const ModelId&) const = default;
};

}  // namespace playhouse::world
