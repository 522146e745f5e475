#pragma once

/// InstanceList: the draw list of one pass: sorted instances and
/// their GPU data. Pure, but keeps its buffers. Frame: E (view.h).

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "playhouse/render/renderer.h"
#include "playhouse/render/view.h"

namespace playhouse::render {

/// Layout of an instance in shaders.
struct CardInstance {
  float rows[12];
  float tint[4];
  std::uint32_t segment, first_bone;
  float glow;
};
static_assert(sizeof(CardInstance) == 76);

/// A draw call: instances [first, first + count) of one shape, or of one level of figures.
struct DrawRun {
  std::uint32_t what = 0, first = 0, count = 0;
};

class InstanceList {
 public:
  void clear() {
    instances.clear();
    runs.clear();
    keys_.clear();
  }
  /// Adds row `row` of instances or figures; sorted by `what`, then by `order`.
  void add(std::uint32_t what, double order, std::uint32_t row) { keys_.push_back({what, order, row}); }
  /// Builds the runs of instances instance_of(row). `one_by_one` (blending): by `order` only, a run each.
  template <typename InstanceOf>
  void finish(bool one_by_one, const InstanceOf& instance_of) {
    sort(one_by_one);
    for (const SortKey& key : keys_) {
      if (one_by_one || runs.empty() || runs.back().what != key.what)
        runs.push_back({key.what, static_cast<std::uint32_t>(instances.size()), 0});
      ++runs.back().count;
      instances.push_back(instance_of(key.row));
    }
  }

  std::vector<CardInstance> instances;
  std::vector<DrawRun> runs;

 private:
  struct SortKey {
    std::uint32_t what = 0;
    double order = 0;
    std::uint32_t row = 0;
  };
  void sort(bool one_by_one);

  std::vector<SortKey> keys_;
};

/// GPU data of an instance, and of a figure whose bones begin at `first_bone`, relative to an eye.
CardInstance seen_from(const geom::Vec3& eye, const Instance& instance);
CardInstance seen_from(const geom::Vec3& eye, const Figure& figure, std::uint32_t first_bone);

}  // namespace playhouse::render
