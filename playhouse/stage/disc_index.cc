#include "playhouse/stage/disc_index.h"

#include <algorithm>
#include <utility>

namespace playhouse::stage {

DiscIndex::DiscIndex(std::size_t count, double mean_radius, std::vector<std::uint8_t> layer)
    : layer_(std::move(layer)), layers_(1) {
  for (const std::uint8_t l : layer_) layers_.resize(std::max<std::size_t>(layers_.size(), l + 1u));
  torus_ = Torus(std::max(6 * mean_radius, 0.01), 2 * count / layers_.size());
  for (std::size_t l = 0; l < layers_.size(); ++l) layers_[l].first_cell = l * torus_.cells();
  first_.resize(layers_.size() * torus_.cells() + 2, 0);
}

void DiscIndex::measure_layers() {
  for (Layer& layer : layers_) layer = {layer.first_cell, 1e300, -1e300, 0};
  for (std::size_t i = 0; i < unsorted_.size(); ++i) {
    Layer& layer = layers_[layer_of(i)];
    layer.z_min = std::min(layer.z_min, unsorted_[i].z_min);
    layer.z_max = std::max(layer.z_max, unsorted_[i].z_max);
    layer.radius_max = std::max(layer.radius_max, unsorted_[i].radius);
  }
  radius_max_ = 0;
  for (const Layer& layer : layers_) radius_max_ = std::max(radius_max_, layer.radius_max);
}

void DiscIndex::sort() {
  measure_layers();
  std::fill(first_.begin(), first_.end(), 0);
  cell_.resize(unsorted_.size());
  // Counts of cell c go two entries on, so that first_[c + 1] is where to put its next disc.
  for (std::size_t i = 0; i < unsorted_.size(); ++i) {
    cell_[i] =
        static_cast<std::uint32_t>(layers_[layer_of(i)].first_cell + torus_.index(unsorted_[i].center));
    ++first_[cell_[i] + 2];
  }
  for (std::size_t c = 1; c < first_.size(); ++c) first_[c] += first_[c - 1];
  discs_.resize(unsorted_.size());
  for (std::size_t i = 0; i < unsorted_.size(); ++i) discs_[first_[cell_[i] + 1]++] = unsorted_[i];
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
