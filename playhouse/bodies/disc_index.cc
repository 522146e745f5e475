#include "playhouse/bodies/disc_index.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace playhouse::bodies {
namespace {

/// Sizes: radii of up to kOrdinary mean radii, then up to kRatio times that, and so on; the last one has the
/// rest.
constexpr double kOrdinary = 1.5, kRatio = 3;
constexpr std::size_t kSizes = 8;

std::size_t size_of(double radius, double mean_radius) {
  double most = kOrdinary * mean_radius;
  std::size_t size = 0;
  for (; size + 1 < kSizes && radius > most; ++size) most *= kRatio;
  return size;
}

/// The radius by which the cells of a size are chosen: near its least one.
double typical_radius(std::size_t size, double mean_radius) {
  double radius = size == 0 ? mean_radius : kOrdinary * mean_radius;
  for (; size > 1; --size) radius *= kRatio;
  return radius;
}

}  // namespace

void DiscIndex::Extent::add(const Extent& other) {
  z_min = std::min(z_min, other.z_min);
  z_max = std::max(z_max, other.z_max);
  radius_max = std::max(radius_max, other.radius_max);
  z_min_last = std::max(z_min_last, other.z_min_last);
  z_max_first = std::min(z_max_first, other.z_max_first);
  is_convex &= other.is_convex;
  is_seen &= other.is_seen;
  centers = {std::min(centers.x_min, other.centers.x_min), std::min(centers.y_min, other.centers.y_min),
             std::max(centers.x_max, other.centers.x_max), std::max(centers.y_max, other.centers.y_max)};
}

bool DiscIndex::is_all_seen(double z_low, double z_high) const {
  return std::all_of(layers_.begin(), layers_.end(), [&](const Layer& layer) {
    return !layer.reaches(z_low, z_high) ||
           (layer.is_seen && layer.z_min_last <= z_low && z_high <= layer.z_max_first);
  });
}

bool DiscIndex::is_all_convex(double z_low, double z_high) const {
  return std::all_of(layers_.begin(), layers_.end(),
                     [&](const Layer& layer) { return !layer.reaches(z_low, z_high) || layer.is_convex; });
}

void DiscIndex::populate(std::size_t count, double mean_radius, std::vector<std::uint8_t> layer,
                         std::span<const double> radius) {
  layer_ = std::move(layer);
  heights_ = 1 + (layer_.empty() ? std::size_t{0} : *std::max_element(layer_.begin(), layer_.end()));
  std::size_t things[kSizes] = {};
  for (const double r : radius) ++things[size_of(r, mean_radius)];
  if (radius.empty()) things[0] = count;
  std::size_t place[kSizes] = {};  // of a size among those that there are
  layers_.clear();
  std::size_t cell = 0, sizes = 0;
  for (std::size_t size = 0; size < kSizes; ++size) {
    if (size > 0 && things[size] == 0) continue;
    place[size] = sizes++;
    const Torus torus(std::max(6 * typical_radius(size, mean_radius), 0.01), 2 * things[size] / heights_);
    for (std::size_t height = 0; height < heights_; ++height, cell += torus.cells())
      layers_.push_back({{}, torus, cell});
  }
  first_.assign(cell + 1, 0);
  radii_.assign(sizes, 0);
  if (sizes == 1) return;
  layer_.resize(count);
  for (std::size_t i = 0; i < count; ++i)
    layer_[i] = static_cast<std::uint8_t>(layer_[i] + heights_ * place[size_of(radius[i], mean_radius)]);
}

std::size_t DiscIndex::most_runs() const {
  std::size_t runs = 1;
  for (const Layer& layer : layers_) runs += 2 * layer.torus.side();
  return runs;
}

/// Chooses the number of blocks: each has to be large enough to pay for its pass over the cells.
void DiscIndex::begin(std::size_t count, const world::Workers& workers) {
  constexpr std::size_t kLeast = 2048;
  blocks_ = std::clamp<std::size_t>(count / kLeast, 1, workers.count());
  unsorted_.resize(count);
  discs_.resize(count);
  cell_.resize(count);
  for (std::vector<double>* column : {&places_.x, &places_.y, &places_.z_min, &places_.z_max})
    column->resize(count + kPad);
  for (std::vector<std::int32_t>* column :
       {&places_.units_x, &places_.units_y, &places_.units_low, &places_.units_high})
    column->resize(count + kPad);
  places_.root.resize(count + kPad);
  next_.resize(blocks_ * cells());
  sums_.resize(blocks_);
  extents_.resize(blocks_ * layers_.size());
}

/// Counts a block's discs per cell.
void DiscIndex::count_up(std::size_t block) {
  std::uint32_t* const counts = next_.data() + block * cells();
  Extent* const extents = extents_.data() + block * layers_.size();
  std::fill_n(counts, cells(), 0);
  std::fill_n(extents, layers_.size(), Extent{});
  const std::size_t end = begin_of(block + 1);
  for (std::size_t i = begin_of(block); i < end; ++i) {
    const Disc& disc = unsorted_[i];
    const std::size_t layer = layer_of(i);
    extents[layer].add({disc.z_min,
                        disc.z_max,
                        disc.radius,
                        disc.z_min,
                        disc.z_max,
                        disc.convex != 0,
                        (disc.seen_by & bit(SeenBy::kRanger)) != 0,
                        {disc.center.x, disc.center.y, disc.center.x, disc.center.y}});
    cell_[i] =
        static_cast<std::uint32_t>(layers_[layer].first_cell + layers_[layer].torus.index(disc.center));
    ++counts[cell_[i]];
  }
}

/// Within a cell, entries are ordered by block, which keeps row order.
void DiscIndex::sort(world::Workers& workers) {
  radius_max_ = 0;
  std::ranges::fill(radii_, 0);
  for (std::size_t l = 0; l < layers_.size(); ++l) {
    static_cast<Extent&>(layers_[l]) = {};
    for (std::size_t block = 0; block < blocks_; ++block)
      layers_[l].add(extents_[block * layers_.size() + l]);
    radius_max_ = std::max(radius_max_, layers_[l].radius_max);
    double& of_size = radii_[l / heights_];
    of_size = std::max(of_size, layers_[l].radius_max);
  }
  const std::size_t cells = this->cells(), blocks = blocks_;
  const auto first_cell = [&](std::size_t share) { return cells * share / blocks; };
  std::uint32_t* const first = first_.data();
  std::uint32_t* const next = next_.data();
  if (blocks > 1)
    each_block(workers, [&](std::size_t share) {
      std::uint32_t sum = 0;
      for (std::size_t block = 0; block < blocks; ++block)
        for (std::size_t c = first_cell(share); c < first_cell(share + 1); ++c)
          sum += next[block * cells + c];
      sums_[share] = sum;
    });
  each_block(workers, [&](std::size_t share) {
    std::uint32_t sum = 0;
    for (std::size_t before = 0; before < share; ++before) sum += sums_[before];
    const std::size_t end = first_cell(share + 1), all = blocks * cells;
    for (std::size_t c = first_cell(share); c < end; ++c) {
      first[c] = sum;
      for (std::size_t at = c; at < all; at += cells) sum += std::exchange(next[at], sum);
    }
  });
  first_.back() = static_cast<std::uint32_t>(unsorted_.size());
  each_block(workers, [&](std::size_t block) { put_places(block); });
}

void DiscIndex::put_places(std::size_t block) {
  std::uint32_t* const next = next_.data() + block * cells();
  const std::size_t end = begin_of(block + 1);
  for (std::size_t i = begin_of(block); i < end; ++i) {
    const std::uint32_t place = next[cell_[i]]++;
    const Disc& disc = discs_[place] = unsorted_[i];
    places_.x[place] = disc.center.x;
    places_.y[place] = disc.center.y;
    places_.units_x[place] = units(disc.center.x);
    places_.units_y[place] = units(disc.center.y);
    const bool is_seen = (disc.seen_by & bit(SeenBy::kRanger)) != 0;
    places_.units_low[place] = is_seen ? height_units(disc.z_min) : std::numeric_limits<std::int32_t>::max();
    places_.units_high[place] = height_units(disc.z_max);
    places_.root[place] = disc.root.index;
    places_.z_min[place] = disc.z_min;
    places_.z_max[place] = disc.z_max;
  }
}

}  // namespace playhouse::bodies
