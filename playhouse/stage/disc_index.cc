#include "playhouse/stage/disc_index.h"

#include <algorithm>

namespace playhouse::stage {

DiscIndex::DiscIndex(std::size_t count, double mean_radius)
    : torus_(std::max(6 * mean_radius, 0.01), 4 * count), first_(torus_.cells() + 1, 0) {}

void DiscIndex::sort() {
  std::fill(first_.begin(), first_.end(), 0);
  cell_.resize(unsorted_.size());
  radius_max_ = 0;
  for (std::size_t i = 0; i < unsorted_.size(); ++i) {
    cell_[i] = static_cast<std::uint32_t>(torus_.index(unsorted_[i].center));
    ++first_[cell_[i] + 1];
    radius_max_ = std::max(radius_max_, unsorted_[i].radius);
  }
  for (std::size_t c = 1; c < first_.size(); ++c) first_[c] += first_[c - 1];
  // Filling from the back leaves first_[c] at the first disc of cell c.
  discs_.resize(unsorted_.size());
  for (std::size_t i = unsorted_.size(); i-- > 0;) discs_[--first_[cell_[i] + 1]] = unsorted_[i];
  // Each entry c + 1 now holds the begin of cell c: shift back.
  for (std::size_t c = 0; c + 1 < first_.size(); ++c) first_[c] = first_[c + 1];
  first_.back() = static_cast<std::uint32_t>(discs_.size());
  for (std::vector<double>* column : {&places_.x, &places_.y, &places_.z_min, &places_.z_max})
    column->resize(discs_.size() + kSpare);
  for (std::size_t i = 0; i < discs_.size(); ++i) {
    places_.x[i] = discs_[i].center.x;
    places_.y[i] = discs_[i].center.y;
    places_.z_min[i] = discs_[i].z_min;
    places_.z_max[i] = discs_[i].z_max;
  }
}

}  // namespace playhouse::stage
