#include <algorithm>
#include <cmath>
#include <unordered_map>
#include <utility>

#include "playhouse/drivers/amcl/particle_filter.h"
#include "playhouse/drivers/amcl/pose_bins.h"

namespace playhouse::drivers {
namespace {

using geom::Pose;

constexpr int kAxisBits = 24;
constexpr std::int64_t kAxisMiddle = std::int64_t{1} << (kAxisBits - 1);
constexpr std::uint64_t kAxisMask = (std::uint64_t{1} << kAxisBits) - 1;

std::uint64_t along(double length) {
  const double bin = std::floor(length / kBinSide), edge = static_cast<double>(kAxisMiddle - 1);
  return static_cast<std::uint64_t>(static_cast<std::int64_t>(std::clamp(bin, -edge, edge)) + kAxisMiddle);
}

std::uint64_t packed(std::uint64_t x, std::uint64_t y, std::uint64_t a) {
  return (a << kAxisBits | x) << kAxisBits | y;
}

/// Sums of the poses of a cluster, about its first one.
struct Sums {
  Pose first;
  std::size_t count = 0;
  double x = 0, y = 0, a = 0, xx = 0, yy = 0, aa = 0, xy = 0, ya = 0, xa = 0;

  void add(const Pose& pose) {
    if (count++ == 0) first = pose;
    const double dx = pose.x - first.x, dy = pose.y - first.y, da = geom::normalize(pose.a - first.a);
    x += dx, y += dy, a += da;
    xx += dx * dx, yy += dy * dy, aa += da * da;
    xy += dx * dy, ya += dy * da, xa += dx * da;
  }
  Hypothesis hypothesis(std::size_t all) const {
    const auto n = static_cast<double>(count);
    const double mx = x / n, my = y / n, ma = a / n;
    return {{{first.x + mx, first.y + my, 0, geom::normalize(first.a + ma)},
             {std::max(xx / n - mx * mx, 0.0), std::max(yy / n - my * my, 0.0),
              std::max(aa / n - ma * ma, 0.0), xy / n - mx * my, ya / n - my * ma, xa / n - mx * ma}},
            n / static_cast<double>(all)};
  }
};

/// Labels bins by the component of neighbouring bins that they are in.
class Components {
 public:
  explicit Components(std::span<const Pose> particles) {
    for (const Pose& particle : particles) labels_.try_emplace(bin_of(particle), kNone);
  }
  std::size_t label_of(const Pose& particle) {
    const std::uint64_t bin = bin_of(particle);
    std::size_t& label = labels_.at(bin);
    if (label == kNone) spread(bin, count_++);
    return labels_.at(bin);
  }

 private:
  static constexpr std::size_t kNone = ~std::size_t{0};

  void spread(std::uint64_t from, std::size_t label) {
    std::vector<std::uint64_t> open{from};
    labels_.at(from) = label;
    while (!open.empty()) {
      const std::uint64_t bin = open.back();
      open.pop_back();
      for (int k = 0; k < 27; ++k) {
        const auto found = labels_.find(neighbour_of(bin, k % 3 - 1, k / 3 % 3 - 1, k / 9 - 1));
        if (found == labels_.end() || found->second != kNone) continue;
        found->second = label;
        open.push_back(found->first);
      }
    }
  }

  std::unordered_map<std::uint64_t, std::size_t> labels_;
  std::size_t count_ = 0;
};

}  // namespace

std::uint64_t bin_of(const geom::Pose& pose) {
  const double share = (pose.a + geom::kPi) / geom::kTwoPi;
  const int heading = std::clamp(static_cast<int>(share * kBinsOfCircle), 0, kBinsOfCircle - 1);
  return packed(along(pose.x), along(pose.y), static_cast<std::uint64_t>(heading));
}

std::uint64_t neighbour_of(std::uint64_t bin, int dx, int dy, int da) {
  const std::uint64_t y = bin & kAxisMask, x = bin >> kAxisBits & kAxisMask, a = bin >> 2 * kAxisBits;
  const auto moved = [](std::uint64_t from, int by) {
    return (from + static_cast<std::uint64_t>(static_cast<std::int64_t>(by))) & kAxisMask;
  };
  return packed(moved(x, dx), moved(y, dy),
                (a + static_cast<std::uint64_t>(da + kBinsOfCircle)) % kBinsOfCircle);
}

std::vector<Hypothesis> hypotheses_of(std::span<const Pose> particles) {
  Components components(particles);
  std::vector<Sums> clusters;  // in the order of their first particles
  for (const Pose& particle : particles) {
    const std::size_t label = components.label_of(particle);
    if (label == clusters.size()) clusters.emplace_back();
    clusters[label].add(particle);
  }
  std::ranges::stable_sort(clusters, std::greater(), &Sums::count);
  if (clusters.size() > kMostHypotheses) clusters.resize(kMostHypotheses);
  std::size_t all = 0;
  for (const Sums& cluster : clusters) all += cluster.count;
  std::vector<Hypothesis> hypotheses;
  for (const Sums& cluster : clusters) hypotheses.push_back(cluster.hypothesis(all));
  return hypotheses;
}

}  // namespace playhouse::drivers
