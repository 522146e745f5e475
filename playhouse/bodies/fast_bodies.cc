#include "playhouse/bodies/fast_bodies.h"

#include <algorithm>

#include "playhouse/bodies/space.h"

namespace playhouse::bodies {
namespace {

/// A tree is fast if it moves this many times as far as those that move do on average; all speeds are
/// ordinary where more than one in kFew of them is fast.
constexpr double kFast = 4;
constexpr std::size_t kFew = 16;

}  // namespace

void FastBodies::find(const Trees& trees, const Solids& solids, const ByRow<Trees, double>& reach,
                      world::Workers& workers) {
  double sum = 0, most = 0;
  std::size_t moving = 0;
  for (const double way : reach) {
    sum += way;
    most = std::max(most, way);
    moving += way > kMargin;  // more than a turn on the spot
  }
  const double limit = kFast * sum / static_cast<double>(std::max<std::size_t>(moving, 1));
  reach_of_others_ = most;
  solids_.clear();
  if (most <= limit) return;
  const auto fast = std::ranges::count_if(reach, [&](double way) { return way > limit; });
  if (kFew * static_cast<std::size_t>(fast) > moving) return;
  is_fast_.assign(trees.size(), 0);
  radius_.clear();
  reach_of_others_ = sum = 0;
  for (const TreeRow tree : trees.rows()) {
    if (reach[tree] <= limit) {
      reach_of_others_ = std::max(reach_of_others_, reach[tree]);
      continue;
    }
    is_fast_[tree] = 1;
    for (const SolidRow row : trees.solids_of(tree)) {
      solids_.push_back(disc_of(solids, row));
      solids_.back().radius += reach[tree] + kMargin;
      radius_.push_back(solids_.back().radius);
      sum += radius_.back();
    }
  }
  index_.populate(solids_.size(), sum / static_cast<double>(std::max<std::size_t>(solids_.size(), 1)), {},
                  radius_);
  index_.rebuild(
      solids_.size(), [&](std::size_t i) { return solids_[i]; }, workers);
}

}  // namespace playhouse::bodies
