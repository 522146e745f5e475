#pragma once

/// InstanceList: what of a scene one pass draws, in the order of draws, and as the card has it. Pure but for
/// its memory, which it keeps. Frame: E (view.h).

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "playhouse/render/renderer.h"
#include "playhouse/render/view.h"

namespace playhouse::render {

/// An instance as shaders have it.
struct CardInstance {
  float rows[12];
  float tint[4];
  std::uint32_t segment, first_bone;
  float glow;
};
static_assert(sizeof(CardInstance) == 76);

/// Draws instances [first, first + count) of one shape, or of one level of figures.
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
  /// Remembers row `row` of instances or figures; runs go by `what`, then by `order`.
  void add(std::uint32_t what, double order, std::uint32_t row) { keys_.push_back({what, order, row}); }
  /// Calls instance_of(row) in the order of runs. Where `one_by_one`, `order` alone counts and each is a run.
  template <typename InstanceOf>
  void finish(bool one_by_one, const InstanceOf& instance_of) {
    sort(one_by_one);
    for (const Key& key : keys_) {
      if (one_by_one || runs.empty() || runs.back().what != key.what)
        runs.push_back({key.what, static_cast<std::uint32_t>(instances.size()), 0});
      ++runs.back().count;
      instances.push_back(instance_of(key.row));
    }
  }

  std::vector<CardInstance> instances;
  std::vector<DrawRun> runs;

 private:
  struct Key {
    std::uint32_t what = 0;
    double order = 0;
    std::uint32_t row = 0;
  };
  void sort(bool one_by_one);

  std::vector<Key> keys_;
};

/// An instance, and a figure whose bones begin at `first_bone`, seen from an eye.
CardInstance seen_from(const geom::Vec3& eye, const Instance& instance);
CardInstance seen_from(const geom::Vec3& eye, const Figure& figure, std::uint32_t first_bone);

}  // namespace playhouse::render
