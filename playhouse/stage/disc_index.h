#pragma once

/// DiscIndex: where things with a centre and a radius are, to find those near a place. Rebuilt by counting,
/// at a cost linear in the number of things, on any number of workers; things of a cell keep their order of
/// rows. Things are kept in layers by height, so that who looks at one height does not come across what is
/// above or below.

#include <cstdint>
#include <span>
#include <vector>

#include "playhouse/stage/observer.h"
#include "playhouse/stage/torus.h"
#include "playhouse/world/workers.h"

namespace playhouse::stage {

class DiscIndex {
 public:
  struct alignas(64) Disc {
    geom::Vec2 center;    // m, in W
    double radius;        // m
    double z_min, z_max;  // m, of what rays may meet: the rest is within others
    std::uint32_t row;    // of whatever was indexed
    std::uint32_t root;   // model row of the top of its tree
    // Of a solid, so that who looks at it need not look it up.
    std::uint32_t first_vertex = 0, vertices = 0;
    std::uint32_t first_corners = 0;  // row of Solids::corners
    std::uint8_t convex = 0;          // corners of a convex polygon that has few (kConvexCorners), else 0
    Observers seen_by = 0;
  };

  DiscIndex() { populate(0, 0.25); }

  /// Sizes the cells for `count` things of this mean radius. `layer` is that of each thing, or empty if there
  /// is one. To be called again when things came or went, before rebuild().
  void populate(std::size_t count, double mean_radius, std::vector<std::uint8_t> layer = {});

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

  /// Places begin .. end - 1 of places() and discs().
  struct Run {
    std::uint32_t begin, end;
  };
  /// The runs, put into `room`, of all in layers that reach those heights and in cells that meet the box
  /// about p, widened by the largest radius. A list, not a visitor: a loop over what is in the runs has to be
  /// a part of a vector function itself, or it is compiled for any processor (vectors.h).
  std::span<const Run> find_runs(geom::Vec2 p, double reach, double z_low, double z_high,
                                 std::vector<Run>& room) const {
    Run* const runs = room.data();
    std::size_t count = 0;
    each_run(p, reach, z_low, z_high, [&](std::uint32_t begin, std::uint32_t end) {
      runs[count] = {begin, end};
      count += begin != end;
    });
    return {runs, count};
  }
  /// For how many runs there has to be room.
  std::size_t most_runs() const { return 2 * layers_.size() * torus_.side() + 1; }
  /// True if all in layers that reach those heights is at each of them, and seen by rangers.
  bool is_all_seen(double z_low, double z_high) const;
  /// True if all in layers that reach those heights is a convex polygon of few corners.
  bool is_all_convex(double z_low, double z_high) const;
  /// What is looked at for every disc near a place, as columns in the order of discs(); kSpare more rows may
  /// be read.
  struct Places {
    std::vector<double> x, y, z_min, z_max;      // m, in W
    std::vector<std::int32_t> units_x, units_y;  // units() of x and y
    // Whole units of height that rangers see it within; none where they do not.
    std::vector<std::int32_t> units_low, units_high;
  };
  /// Whole numbers that say exactly how far things are from each other, wherever in the world, up to
  /// kFarthest: they wrap round, so only differences count.
  static constexpr double kPerMetre = 4096, kFarthest = 5e5;
  static std::int32_t units(double x) {
    constexpr double kFar = 1e15;
    const double scaled = kPerMetre * (x > kFar ? kFar : x < -kFar ? -kFar : x);
    return static_cast<std::int32_t>(static_cast<std::int64_t>(scaled));
  }
  /// Of heights, which do not wrap round: what is higher is never less.
  static std::int32_t height_units(double z) {
    constexpr double kFar = 1 << 30;
    const double scaled = kPerMetre * z;
    return static_cast<std::int32_t>(scaled > kFar ? kFar : scaled < -kFar ? -kFar : scaled);
  }
  static constexpr std::size_t kSpare = 8;
  const Places& places() const { return places_; }
  const Disc* discs() const { return discs_.data(); }

  /// Calls visit(disc) for everything of find_runs(). The caller tests what it needs: there may be far things
  /// among them.
  template <typename Visit>
  void near(geom::Vec2 p, double reach, double z_low, double z_high, const Visit& visit) const {
    each_run(p, reach, z_low, z_high, [&](std::uint32_t begin, std::uint32_t end) {
      for (std::uint32_t i = begin; i < end; ++i) visit(discs_[i]);
    });
  }

 private:
  template <typename Visit>
  void each_run(geom::Vec2 p, double reach, double z_low, double z_high, const Visit& visit) const {
    for (const Layer& layer : layers_) {
      if (!layer.reaches(z_low, z_high)) continue;
      const std::uint32_t* const first_of = first_.data() + layer.first_cell;
      torus_.runs(box_about(p, reach + layer.radius_max),
                  [&](std::size_t first, std::size_t last) { visit(first_of[first], first_of[last + 1]); });
    }
  }

  /// What is in a layer.
  struct Extent {
    double z_min = 1e300, z_max = -1e300, radius_max = 0;  // m
    double z_min_last = -1e300, z_max_first = 1e300;       // m: the highest z_min, the lowest z_max
    bool is_convex = true;                                 // all of it, and of few corners
    bool is_seen = true;                                   // all of it, by rangers

    bool reaches(double z_low, double z_high) const { return z_min <= z_high && z_low <= z_max; }

    void add(const Extent& other);
  };
  struct Layer : Extent {
    std::size_t first_cell;
  };

  void begin(std::size_t count, const world::Workers& workers);
  void count_up(std::size_t block);
  void sort(world::Workers& workers);
  void put_places(std::size_t block);
  std::size_t begin_of(std::size_t block) const { return unsorted_.size() * block / blocks_; }
  std::size_t layer_of(std::size_t i) const { return layer_.empty() ? 0 : layer_[i]; }
  std::size_t cells() const { return layers_.size() * torus_.cells(); }
  template <typename Body>
  void each_block(world::Workers& workers, const Body& body) const {
    workers.run(blocks_, 1, [&](std::size_t first, std::size_t last) {
      for (std::size_t block = first; block < last; ++block) body(block);
    });
  }

  Torus torus_;
  std::vector<std::uint8_t> layer_;  // of unsorted_, or empty
  std::vector<Layer> layers_;
  double radius_max_ = 0;
  std::vector<Disc> unsorted_, discs_;  // discs_ by layer and cell
  Places places_;
  std::vector<std::uint32_t> cell_;   // of unsorted_
  std::vector<std::uint32_t> first_;  // first disc of a cell (layers x cells + 1)
  // Things are counted in blocks of consecutive rows, one for each worker where there are so many.
  std::size_t blocks_ = 1;
  std::vector<std::uint32_t> next_;  // where a block puts its next disc of a cell (blocks x layers x cells)
  std::vector<std::uint32_t> sums_;  // of discs in a share of the cells (blocks)
  std::vector<Extent> extents_;      // (blocks x layers)
};

}  // namespace playhouse::stage
