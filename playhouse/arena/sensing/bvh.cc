#include "playhouse/arena/sensing/bvh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "playhouse/base/assert.h"

namespace playhouse::arena {
namespace {

constexpr std::size_t kBins = 32;
// Nodes deeper than this are split in equal halves: bounds the depth whatever the boxes are.
constexpr std::size_t kHeuristicDepth = 8;

struct Range {
  std::size_t first = 0, count = 0;  // rows of Bvh::order
  Bounds box;
};

/// Twice the middle of a box.
float middle(const Bounds& box, std::size_t axis) {
  return box.low[axis] + box.high[axis];
}

class Builder {
 public:
  Builder(std::span<const Bounds> boxes, std::size_t leaf_size) : boxes_(boxes), leaf_size_(leaf_size) {
    bvh_.order.resize(boxes.size());
    for (std::size_t i = 0; i < boxes.size(); ++i) bvh_.order[i] = static_cast<std::uint32_t>(i);
  }
  Bvh build() {
    if (boxes_.empty()) return {};
    const Range all = range(0, boxes_.size());
    bvh_.box = all.box;
    add_node(all, 1);
    return std::move(bvh_);
  }

 private:
  /// A split at a bin's lower limit; no axis: none.
  struct Split {
    std::size_t axis = 3, bin = 0;
    float cost = Bounds::kInfinity;
  };

  const Bounds& box(std::size_t row) const { return boxes_[bvh_.order[row]]; }
  Range range(std::size_t first, std::size_t count) const;
  std::uint32_t add_node(const Range& range, std::size_t depth);
  std::vector<Range> children(const Range& range, std::size_t depth);
  std::pair<Range, Range> split(const Range& range, std::size_t depth);
  std::size_t halve(const Range& range, const Bounds& middles);
  Split best_split(const Range& range, const Bounds& middles) const;
  void try_axis(const Range& range, const Bounds& middles, std::size_t axis, Split& best) const;
  static std::size_t bin(const Bounds& box, const Bounds& middles, std::size_t axis);
  /// Visits of leaves that a ray among `count` boxes costs, and a little for each box, so that ties are
  /// decided.
  float cost(std::size_t count) const {
    const float leaves = static_cast<float>(count) / static_cast<float>(leaf_size_);
    return std::ceil(leaves) + 0.15f * leaves;
  }

  std::span<const Bounds> boxes_;
  std::size_t leaf_size_;
  Bvh bvh_;
};

Range Builder::range(std::size_t first, std::size_t count) const {
  Range all{first, count, {}};
  for (std::size_t row = first; row < first + count; ++row) all.box.add(box(row));
  return all;
}

std::uint32_t Builder::add_node(const Range& range, std::size_t depth) {
  PLAYHOUSE_ASSERT(depth <= Bvh::kDepthMax);
  const auto node = static_cast<std::uint32_t>(bvh_.nodes.size());
  bvh_.nodes.emplace_back();
  const std::vector<Range> parts = children(range, depth);
  for (std::size_t i = 0; i < Bvh::kWidth; ++i) {
    const Range part = i < parts.size() ? parts[i] : Range();
    for (std::size_t axis = 0; axis < 3; ++axis) {
      bvh_.nodes[node].low[axis][i] = part.box.low[axis];
      bvh_.nodes[node].high[axis][i] = part.box.high[axis];
    }
    std::uint32_t child = 0;
    if (part.count > leaf_size_) {
      child = add_node(part, depth + 1);
    } else if (part.count > 0) {
      child = static_cast<std::uint32_t>(bvh_.leaves.size()) | Bvh::kLeaf;
      bvh_.leaves.push_back({static_cast<std::uint32_t>(part.first), static_cast<std::uint32_t>(part.count)});
    }
    bvh_.nodes[node].child[i] = child;
  }
  return node;
}

/// Splits a range until there is a part for each child: the part with the largest surface first, which
/// most rays would have to open.
std::vector<Range> Builder::children(const Range& all, std::size_t depth) {
  std::vector<Range> parts;
  if (leaf_size_ == 1 && all.count <= Bvh::kWidth) {
    for (std::size_t i = 0; i < all.count; ++i) parts.push_back(range(all.first + i, 1));
    return parts;
  }
  parts.push_back(all);
  while (parts.size() < Bvh::kWidth) {
    std::size_t largest = parts.size();
    float area = -1;
    for (std::size_t i = 0; i < parts.size(); ++i) {
      if (parts[i].count <= leaf_size_ || parts[i].box.area() <= area) continue;
      area = parts[i].box.area();
      largest = i;
    }
    if (largest == parts.size()) break;
    const auto [left, right] = split(parts[largest], depth);
    parts[largest] = left;
    parts.push_back(right);
  }
  return parts;
}

std::pair<Range, Range> Builder::split(const Range& all, std::size_t depth) {
  Bounds middles;
  for (std::size_t row = all.first; row < all.first + all.count; ++row)
    for (std::size_t axis = 0; axis < 3; ++axis) {
      middles.low[axis] = std::min(middles.low[axis], middle(box(row), axis));
      middles.high[axis] = std::max(middles.high[axis], middle(box(row), axis));
    }
  const Split best = depth <= kHeuristicDepth ? best_split(all, middles) : Split();
  std::size_t left = all.count / 2;
  if (best.axis < 3) {
    const auto begin = bvh_.order.begin() + static_cast<std::ptrdiff_t>(all.first);
    const auto end =
        std::partition(begin, begin + static_cast<std::ptrdiff_t>(all.count),
                       [&](std::uint32_t row) { return bin(boxes_[row], middles, best.axis) < best.bin; });
    left = static_cast<std::size_t>(end - begin);
  } else {
    left = halve(all, middles);
  }
  return {range(all.first, left), range(all.first + left, all.count - left)};
}

/// Orders a range into halves along the longest axis; returns the size of the first.
std::size_t Builder::halve(const Range& all, const Bounds& middles) {
  std::size_t axis = 0;
  for (std::size_t k = 1; k < 3; ++k)
    if (middles.high[k] - middles.low[k] > middles.high[axis] - middles.low[axis]) axis = k;
  const auto begin = bvh_.order.begin() + static_cast<std::ptrdiff_t>(all.first);
  const std::size_t left = all.count / 2;
  std::nth_element(begin, begin + static_cast<std::ptrdiff_t>(left),
                   begin + static_cast<std::ptrdiff_t>(all.count), [&](std::uint32_t a, std::uint32_t b) {
                     return std::pair(middle(boxes_[a], axis), a) < std::pair(middle(boxes_[b], axis), b);
                   });
  return left;
}

std::size_t Builder::bin(const Bounds& box, const Bounds& middles, std::size_t axis) {
  const float share = (middle(box, axis) - middles.low[axis]) / (middles.high[axis] - middles.low[axis]);
  if (!(share < 1)) return kBins - 1;  // also not a number, of coordinates too large for a float
  return static_cast<std::size_t>(share * kBins);
}

Builder::Split Builder::best_split(const Range& all, const Bounds& middles) const {
  Split best;
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (middles.high[axis] > middles.low[axis]) try_axis(all, middles, axis, best);
  return best;
}

void Builder::try_axis(const Range& all, const Bounds& middles, std::size_t axis, Split& best) const {
  struct Bin {
    Bounds box;
    std::size_t count = 0;
  };
  std::array<Bin, kBins> bins;
  for (std::size_t row = all.first; row < all.first + all.count; ++row) {
    Bin& to = bins[bin(box(row), middles, axis)];
    to.box.add(box(row));
    ++to.count;
  }
  std::array<float, kBins> right;  // cost of the bins from here on
  Bin sum;
  for (std::size_t k = kBins - 1; k > 0; --k) {
    sum.box.add(bins[k].box);
    sum.count += bins[k].count;
    right[k] = sum.box.area() * cost(sum.count);
  }
  sum = {};
  for (std::size_t k = 1; k < kBins; ++k) {
    sum.box.add(bins[k - 1].box);
    sum.count += bins[k - 1].count;
    if (sum.count == 0 || sum.count == all.count) continue;
    const float total = sum.box.area() * cost(sum.count) + right[k];
    if (total < best.cost) best = {axis, k, total};
  }
}

}  // namespace

void Bounds::add(const Bounds& other) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    low[axis] = std::min(low[axis], other.low[axis]);
    high[axis] = std::max(high[axis], other.high[axis]);
  }
}

float Bounds::area() const {
  const float x = high[0] - low[0], y = high[1] - low[1], z = high[2] - low[2];
  return x < 0 ? 0 : x * y + y * z + z * x;
}

Bvh bvh_of(std::span<const Bounds> boxes, std::size_t leaf_size) {
  return Builder(boxes, leaf_size).build();
}

}  // namespace playhouse::arena
