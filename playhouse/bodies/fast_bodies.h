#pragma once

/// FastBodies: the few trees that move much farther in a tick than the others do, apart from these, so that a
/// bound on the motion of all others is small: one fast body costs those that are near it, and nobody else.
///
/// In: how far the centers of each tree's solids move in this tick, at most.
/// Out: a bound for all trees that are not fast; an index of the solids of the fast ones, as circles about
///   their places before this tick that hold them wherever they go in it.
/// Cost: two passes over the trees; the index of the fast ones, if there are any.

#include <cstdint>
#include <span>
#include <vector>

#include "playhouse/bodies/bodies.h"
#include "playhouse/bodies/disc_index.h"

namespace playhouse::bodies {

class FastBodies {
 public:
  /// `reach`: bounds on the displacement of the centers of a tree's solids. [m] (trees)
  void find(const Trees& trees, const Solids& solids, const ByRow<Trees, double>& reach,
            world::Workers& workers);

  bool empty() const { return solids_.empty(); }
  bool is_fast(TreeRow tree) const { return !empty() && is_fast_[tree] != 0; }
  /// Bound on the displacement of the centers of all solids that are not of fast trees. [m]
  double reach_of_others() const { return reach_of_others_; }
  /// The solids of fast trees, each with a circle that holds it throughout this tick; row: of Solids.
  const DiscIndex& index() const { return index_; }

 private:
  ByRow<Trees, std::uint8_t> is_fast_;  // (trees)
  std::vector<DiscIndex::Disc> solids_;
  std::vector<double> radius_;  // of solids_ [m]
  double reach_of_others_ = 0;
  DiscIndex index_;
};

}  // namespace playhouse::bodies
