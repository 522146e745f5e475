#pragma once

/// Value types of properties.

namespace playhouse::scene {

struct Color {
  float r = 1, g = 0, b = 0, a = 1;  // 0..1
  friend bool operator==(const Color&, const Color&) = default;
};

/// A closed interval.
struct Interval {
  double min = 0, max = 0;
  friend bool operator==(const Interval&, const Interval&) = default;
};

}  // namespace playhouse::scene
