#pragma once

/// CostBuckets: cells that wait for their turn, by cost, the cheapest first. A ring of buckets, as no cell that
/// is added costs more than the current one by more than the ring is long.

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "playhouse/drivers/wavefront/cost_map.h"

namespace playhouse::drivers {

class CostBuckets {
 public:
  explicit CostBuckets(std::uint32_t most_more) : buckets_(std::size_t{most_more} + 1) {}

  void add(CellIndex cell, std::uint64_t cost) {
    buckets_[cost % buckets_.size()].push_back(cell);
    ++count_;
  }
  bool empty() const { return count_ == 0; }
  bool has(std::uint64_t cost) const { return !buckets_[cost % buckets_.size()].empty(); }
  /// The last that was added of those of this cost, which there are.
  CellIndex take_last(std::uint64_t cost) {
    std::vector<CellIndex>& cells = buckets_[cost % buckets_.size()];
    const CellIndex cell = cells.back();
    cells.pop_back();
    --count_;
    return cell;
  }
  /// All cells of this cost.
  std::vector<CellIndex> take(std::uint64_t cost) {
    std::vector<CellIndex> cells = std::exchange(buckets_[cost % buckets_.size()], std::move(spare_));
    count_ -= cells.size();
    return cells;
  }
  /// Gives a taken vector back, for its memory.
  void reuse(std::vector<CellIndex> cells) {
    spare_ = std::move(cells);
    spare_.clear();
  }

 private:
  std::vector<std::vector<CellIndex>> buckets_;
  std::vector<CellIndex> spare_;
  std::size_t count_ = 0;
};

}  // namespace playhouse::drivers
