#pragma once

/// Values of properties that are neither numbers nor places.

namespace playhouse::scene {

struct Color {
  float r = 1, g = 0, b = 0, a = 1;  // 0..1
  friend bool operator==(const Color&, const Color&) = default;
};

/// From `min` to `max`, both included.
struct Bounds {
  double min = 0, max = 0;
  friend bool operator==(const Bounds&, const Bounds&) = default;
};

}  // namespace playhouse::scene
