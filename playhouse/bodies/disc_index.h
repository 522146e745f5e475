#pragma once

/// DiscIndex: broad phase of movable things, bounding circles in a hashed uniform
/// grid (torus.h). Rebuilt by a parallel counting sort in linear time; entries of a
/// cell stay in row order for any number of workers. Entries are split into layers by
/// height, so that a query at one height skips what is entirely above or below it, and by
/// size, each size with a grid of its own, so that a query is inflated by large radii only
/// where it looks for large things: one of them makes no other query dearer.
///
/// In: circles, each with a range of heights, its row and its root.
/// Out: the runs of things that may be near a place.
/// Cost: rebuild() visits all things and cells; a query the cells of its box, in each layer at its
///   heights.

#include <cstdint>
#include <span>
#include <vector>

#include "playhouse/bodies/rows.h"
#include "playhouse/bodies/seen_by.h"
#include "playhouse/bodies/torus.h"
#include "playhouse/world/models.h"
#include "playhouse/world/workers.h"

namespace playhouse::bodies {

class DiscIndex {
 public:
  struct alignas(64) Disc {
    geom::Vec2 center;     // m, in W
    double radius;         // m
    double z_min, z_max;   // m, of the part that rays can hit: not enclosed (enclosure.h)
    std::uint32_t row;     // of the indexed table: solid() or model()
    world::ModelRow root;  // of its tree
    // Copied from Solids, which saves a lookup per visit.
    VertexRow first_vertex{};
    std::uint32_t vertices = 0;
    CornersRow first_corners{};
    std::uint8_t convex = 0;  // corners of a convex polygon, 0: concave or > kConvexCorners
    SeenByBits seen_by = 0;

    SolidRow solid() const { return {row}; }
    world::ModelRow model() const { return {row}; }
  };

  DiscIndex() { populate(0, 0.25); }

  /// Sizes the cells for `count` things of this mean radius. `layer` holds the layer by height of each thing;
  /// empty: one layer. `radius` holds their radii [m]; empty: none is much larger than the mean.
  /// Call it before rebuild() when the population has changed.
  void populate(std::size_t count, double mean_radius, std::vector<std::uint8_t> layer = {},
                std::span<const double> radius = {});

  /// Replaces the contents. `disc(i)` gives thing i < count.
  template <typename MakeDisc>
  void rebuild(std::size_t count, const MakeDisc& disc, world::Workers& workers) {
    begin(count, workers);
    each_block(workers, [&](std::size_t block) {
      const std::size_t end = begin_of(block + 1);
      for (std::size_t i = begin_of(block); i < end; ++i) unsorted_[i] = disc(i);
      count_up(block);
    });
    sort(workers);
  }

  double radius_max() const { return radius_max_; }
  /// The largest radius of each size, that of the smallest and most things first. [m]
  std::span<const double> radii() const { return radii_; }

  /// Entries begin .. end - 1 of places() and discs().
  struct Run {
    std::uint32_t begin, end;
  };
  /// Writes to `room` the runs of things of one size, in all layers at those heights and all cells that
  /// intersect the box about p, inflated by radii()[size]. A list, not a visitor: a loop over a run must be
  /// inlined into a vector function, otherwise it is compiled for the baseline processor (vectors.h).
  std::span<const Run> find_runs(std::size_t size, geom::Vec2 p, double reach, double z_low, double z_high,
                                 std::vector<Run>& room) const {
    Run* const runs = room.data();
    std::size_t count = 0;
    each_run(layers_of(size), p, reach, z_low, z_high, [&](std::uint32_t begin, std::uint32_t end) {
      runs[count] = {begin, end};
      count += begin != end;
    });
    return {runs, count};
  }
  /// Upper bound on the number of runs, for sizing `room`.
  std::size_t most_runs() const;
  /// True if everything in layers at those heights spans them and is visible to rangers: no test per disc.
  bool is_all_seen(double z_low, double z_high) const;
  /// True if everything in layers at those heights is a convex polygon of few corners.
  bool is_all_convex(double z_low, double z_high) const;
  /// The fields read for every disc of a run as columns,
  /// in the order of discs(); padded by kPad rows.
  struct Places {
    std::vector<double> x, y, z_min, z_max;      // m, in W
    std::vector<std::int32_t> units_x, units_y;  // units() of x, y
    // Height range in height_units() in which rangers see it; an empty range if they do not.
    std::vector<std::int32_t> units_low, units_high;
    std::vector<std::uint32_t> root;  // model row of the root of its tree
  };
  /// Fixed-point coordinates: differences are exact up to kFarthest, anywhere
  /// in the world. They wrap around, so only differences mean anything.
  static constexpr double kPerMetre = 4096, kFarthest = 5e5;
  static std::int32_t units(double x) {
    constexpr double kFar = 1e15;
    const double scaled = kPerMetre * (x > kFar ? kFar : x < -kFar ? -kFar : x);
    return static_cast<std::int32_t>(static_cast<std::int64_t>(scaled));
  }
  /// Fixed-point heights: they saturate instead of wrapping, so comparisons are valid.
  static std::int32_t height_units(double z) {
    constexpr double kFar = 1 << 30;
    const double scaled = kPerMetre * z;
    return static_cast<std::int32_t>(scaled > kFar ? kFar : scaled < -kFar ? -kFar : scaled);
  }
  static constexpr std::size_t kPad = 8;
  const Places& places() const { return places_; }
  const Disc* discs() const { return discs_.data(); }

  /// Calls visit(disc) for everything in the runs of find_runs(), size by size.
  /// Conservative: the caller has to test distance, height and visibility.
  template <typename Visit>
  void near(geom::Vec2 p, double reach, double z_low, double z_high, const Visit& visit) const {
    each_run(layers_, p, reach, z_low, z_high, [&](std::uint32_t begin, std::uint32_t end) {
      for (std::uint32_t i = begin; i < end; ++i) visit(discs_[i]);
    });
  }

 private:
  struct Layer;

  std::span<const Layer> layers_of(std::size_t size) const {
    return std::span<const Layer>(layers_).subspan(size * heights_, heights_);
  }
  template <typename Visit>
  void each_run(std::span<const Layer> layers, geom::Vec2 p, double reach, double z_low, double z_high,
                const Visit& visit) const {
    for (const Layer& layer : layers) {
      // A grid wraps around: the box spares those that are far from a few large things the look at its cells.
      if (!layer.reaches(z_low, z_high) || !layer.centers.grown(reach + layer.radius_max).contains(p))
        continue;
      const std::uint32_t* const first_of = first_.data() + layer.first_cell;
      layer.torus.runs(box_about(p, reach + layer.radius_max), [&](std::size_t first, std::size_t last) {
        visit(first_of[first], first_of[last + 1]);
      });
    }
  }

  /// Bounds of a layer's contents.
  struct Extent {
    double z_min = 1e300, z_max = -1e300, radius_max = 0;  // m
    double z_min_last = -1e300, z_max_first = 1e300;       // m: the highest z_min, the lowest z_max
    bool is_convex = true;                                 // all are convex, of few corners
    bool is_seen = true;                                   // all are visible to rangers

    geom::Box centers;  // m

    bool reaches(double z_low, double z_high) const { return z_min <= z_high && z_low <= z_max; }

    void add(const Extent& other);
  };
  struct Layer : Extent {
    Torus torus;
    std::size_t first_cell = 0;
  };

  void begin(std::size_t count, const world::Workers& workers);
  void count_up(std::size_t block);
  void sort(world::Workers& workers);
  void put_places(std::size_t block);
  std::size_t begin_of(std::size_t block) const { return unsorted_.size() * block / blocks_; }
  std::size_t layer_of(std::size_t i) const { return layer_.empty() ? 0 : layer_[i]; }
  std::size_t cells() const { return layers_.back().first_cell + layers_.back().torus.cells(); }
  template <typename Body>
  void each_block(world::Workers& workers, const Body& body) const {
    workers.run(blocks_, 1, [&](std::size_t first, std::size_t last) {
      for (std::size_t block = first; block < last; ++block) body(block);
    });
  }

  std::vector<std::uint8_t> layer_;     // of unsorted_, or empty
  std::vector<Layer> layers_;           // the heights of the smallest size, then those of the next one
  std::size_t heights_ = 1;             // layers of a size
  double radius_max_ = 0;               // m
  std::vector<double> radii_;           // (sizes)
  std::vector<Disc> unsorted_, discs_;  // discs_ by layer and cell
  Places places_;
  std::vector<std::uint32_t> cell_;   // of unsorted_
  std::vector<std::uint32_t> first_;  // first disc of a cell (cells of all layers + 1)
  // The counting sort counts blocks of consecutive rows, one per worker for large counts.
  std::size_t blocks_ = 1;
  std::vector<std::uint32_t> next_;  // next slot of a block in a cell (blocks x cells of all layers)
  std::vector<std::uint32_t> sums_;  // discs in a share of the cells, for the prefix sum (blocks)
  std::vector<Extent> extents_;      // (blocks x layers)
};

}  // namespace playhouse::bodies
