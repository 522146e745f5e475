#include "playhouse/geom/trapezoids.h"

#include <algorithm>
#include <cstdint>
#include <utility>

namespace playhouse::geom {
namespace {

/// A non-horizontal side of an outline, directed upwards.
struct Side {
  Vec2 low, high;
  double x_at(double y) const {
    if (y <= low.y) return low.x;
    if (y >= high.y) return high.x;
    return low.x + (high.x - low.x) * ((y - low.y) / (high.y - low.y));
  }
};

/// A trapezoid that is still open at the sweep line.
struct Open {
  std::uint32_t left, right;  // sides
  double y_low;
  auto sides() const { return std::pair(left, right); }
};

std::vector<Side> sides_of(std::span<const Outline> outlines) {
  std::vector<Side> sides;
  for (const Outline outline : outlines)
    for (std::size_t i = 0; i < outline.size(); ++i) {
      const Vec2 a = outline[i], b = outline[(i + 1) % outline.size()];
      if (a.y < b.y) sides.push_back({a, b});
      if (b.y < a.y) sides.push_back({b, a});
    }
  std::ranges::sort(sides, {}, [](const Side& side) { return std::pair(side.low.y, side.low.x); });
  return sides;
}

std::vector<double> heights_of(const std::vector<Side>& sides) {
  std::vector<double> heights;
  for (const Side& side : sides) {
    heights.push_back(side.low.y);
    heights.push_back(side.high.y);
  }
  std::ranges::sort(heights);
  heights.erase(std::unique(heights.begin(), heights.end()), heights.end());
  return heights;
}

}  // namespace

std::vector<Trapezoid> trapezoids(std::span<const Outline> outlines) {
  const std::vector<Side> sides = sides_of(outlines);
  const std::vector<double> heights = heights_of(sides);
  std::vector<Trapezoid> made;
  const auto close = [&](const Open& open, double y) {
    const Side &left = sides[open.left], &right = sides[open.right];
    made.push_back(
        {open.y_low, y, left.x_at(open.y_low), left.x_at(y), right.x_at(open.y_low), right.x_at(y)});
  };
  std::vector<std::uint32_t> here;  // sides that cross this strip
  std::vector<Open> open, next;
  std::uint32_t begun = 0;
  for (std::size_t k = 0; k + 1 < heights.size(); ++k) {
    const double y = heights[k], middle = (y + heights[k + 1]) / 2;
    std::erase_if(here, [&](std::uint32_t side) { return sides[side].high.y <= y; });
    while (begun < sides.size() && sides[begun].low.y <= y) here.push_back(begun++);
    std::ranges::sort(here, {},
                      [&](std::uint32_t side) { return std::pair(sides[side].x_at(middle), side); });
    // Trapezoids with the same sides as in the strip below continue; others are closed.
    next.clear();
    for (std::size_t i = 0; i + 1 < here.size(); i += 2) next.push_back({here[i], here[i + 1], y});
    std::ranges::sort(next, {}, &Open::sides);
    auto from = next.begin();
    for (const Open& below : open) {
      while (from != next.end() && from->sides() < below.sides()) ++from;
      if (from != next.end() && from->sides() == below.sides())
        from->y_low = below.y_low;
      else
        close(below, y);
    }
    std::swap(open, next);
  }
  for (const Open& last : open) close(last, heights.back());
  return made;
}

}  // namespace playhouse::geom
