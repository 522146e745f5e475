#pragma once

/// Torus: a uniform grid whose cell coordinates wrap around in both directions, so that a
/// world of any extent needs a fixed number of cells. Distant places share a cell, so callers
/// test true coordinates. Cells of a row are consecutive: a box of cells is a few runs.
///
/// In: coordinates in W. [m]
/// Out: indices of cells.
/// Cost: constant; runs() has one or two runs for each row of cells of the box.

#include <cmath>
#include <cstddef>
#include <cstdint>

#include "playhouse/geom/pose.h"

namespace playhouse::bodies {

class Torus {
 public:
  Torus() = default;
  /// At least `cells` cells of side `cell` metres; the number per side is a power of two.
  Torus(double cell, std::size_t cells) : cell_(cell), per_metre_(1.0 / cell) {
    while (side() * side() < cells && bits_ < 12) ++bits_;
  }

  double cell() const { return cell_; }
  unsigned bits() const { return bits_; }
  std::size_t side() const { return std::size_t{1} << bits_; }
  std::size_t cells() const { return side() * side(); }

  /// The unwrapped cell coordinate of x.
  std::int64_t along(double x) const {
    constexpr double kFar = 1e15;  // saturates; any cell is correct there
    double scaled = x * per_metre_;
    scaled = scaled > kFar ? kFar : scaled < -kFar ? -kFar : scaled;
    const auto towards_zero = static_cast<std::int64_t>(scaled);
    return towards_zero - (static_cast<double>(towards_zero) > scaled ? 1 : 0);
  }
  std::size_t wrap(std::int64_t c) const { return static_cast<std::size_t>(c) & (side() - 1); }
  std::size_t index(std::int64_t cx, std::int64_t cy) const { return (wrap(cy) << bits_) + wrap(cx); }
  std::size_t index(geom::Vec2 p) const { return index(along(p.x), along(p.y)); }

  /// Calls visit(first, last) for runs of cell indices, last included, that cover the box; each cell once.
  template <typename Visit>
  void runs(const geom::Box& box, const Visit& visit) const {
    const std::int64_t x0 = along(box.x_min), x1 = along(box.x_max);
    const std::int64_t y0 = along(box.y_min), y1 = along(box.y_max);
    const auto limit = static_cast<std::int64_t>(side());
    const std::int64_t rows = y1 - y0 + 1 < limit ? y1 - y0 + 1 : limit;
    const bool whole = x1 - x0 + 1 >= limit;
    const std::size_t left = whole ? 0 : wrap(x0), right = whole ? side() - 1 : wrap(x1);
    for (std::int64_t row = 0; row < rows; ++row) {
      const std::size_t base = wrap(y0 + row) << bits_;
      if (left <= right) {
        visit(base + left, base + right);
      } else {
        visit(base + left, base + side() - 1);
        visit(base, base + right);
      }
    }
  }

 private:
  double cell_ = 1, per_metre_ = 1;
  unsigned bits_ = 4;
};

inline geom::Box box_about(geom::Vec2 p, double reach) {
  return {p.x - reach, p.y - reach, p.x + reach, p.y + reach};
}

}  // namespace playhouse::bodies
