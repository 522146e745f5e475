#include "playhouse/drivers/amcl/particle_filter.h"

#include <algorithm>
#include <cmath>
#include <unordered_set>
#include <utility>

#include "playhouse/base/rng.h"
#include "playhouse/drivers/amcl/pose_bins.h"
#include "playhouse/geom/exponential.h"

namespace playhouse::drivers {
namespace {

using geom::Pose;

constexpr double kMostVariance = 1e12;  // m^2, rad^2

/// Lower triangular L with L L^T the covariance.
struct Root {
  double xx = 0, yx = 0, yy = 0, ax = 0, ay = 0, aa = 0;
};

/// None if it is not positive semidefinite, up to rounding.
std::optional<Root> root_of(const std::array<double, 6>& cov) {
  const auto [xx, yy, aa, xy, ya, xa] = cov;
  const double least = -1e-9 * (std::fabs(xx) + std::fabs(yy) + std::fabs(aa));
  const auto over = [](double value, double by) { return by > 0 ? value / by : 0; };
  Root root;
  if (!(xx >= 0 && xx <= kMostVariance && yy <= kMostVariance && aa <= kMostVariance)) return std::nullopt;
  // What does not vary does not covary.
  if ((xx == 0 && (xy != 0 || xa != 0)) || (yy == 0 && (xy != 0 || ya != 0)) ||
      (aa == 0 && (xa != 0 || ya != 0)))
    return std::nullopt;
  root.xx = std::sqrt(xx);
  root.yx = over(xy, root.xx);
  root.ax = over(xa, root.xx);
  const double y2 = yy - root.yx * root.yx;
  if (!(y2 >= least)) return std::nullopt;
  root.yy = std::sqrt(std::max(y2, 0.0));
  root.ay = over(ya - root.ax * root.yx, root.yy);
  const double a2 = aa - root.ax * root.ax - root.ay * root.ay;
  if (!(a2 >= least && std::fabs(ya - root.ax * root.yx - root.ay * root.yy) <= -least)) return std::nullopt;
  root.aa = std::sqrt(std::max(a2, 0.0));
  return root;
}

Pose drawn(const PoseBelief& belief, const Root& root, Rng& random) {
  const double u = random.gaussian(), v = random.gaussian(), w = random.gaussian();
  return {belief.mean.x + root.xx * u, belief.mean.y + root.yx * u + root.yy * v, 0,
          geom::normalize(belief.mean.a + root.ax * u + root.ay * v + root.aa * w)};
}

Pose random_pose(const LikelihoodField& field, Rng& random) {
  const geom::Vec2 p = field.free_place(random.uniform());
  return {p.x, p.y, 0, random.uniform(-geom::kPi, geom::kPi)};
}

/// Of a belief, on free floor if some of the draws are there.
Pose drawn_on_floor(const PoseBelief& belief, const Root& root, const LikelihoodField& field, Rng& random) {
  constexpr int kTries = 20;
  Pose pose = drawn(belief, root, random);
  for (int i = 1; i < kTries && !field.is_free(pose.xy()); ++i) pose = drawn(belief, root, random);
  return pose;
}

/// Number of particles that keeps the error with the wanted probability, by the number of bins that they are
/// in.
double wanted(const AmclOptions& options, std::size_t bins) {
  if (bins < 2) return 0;
  const double k = static_cast<double>(bins) - 1, part = 2 / (9 * k);
  const double root = 1 - part + std::sqrt(part) * options.kld_z;
  return k / (2 * options.kld_error) * root * root * root;
}

/// Draws particles until there are enough for the bins that they are in. `draw` returns one.
template <typename Draw>
void draw_enough(const AmclOptions& options, const Draw& draw) {
  std::unordered_set<std::uint64_t> bins;
  for (std::size_t count = 1; count <= options.max_particles; ++count) {
    bins.insert(bin_of(draw()));
    if (count >= options.min_particles && static_cast<double>(count) >= wanted(options, bins.size())) break;
  }
}

void move(const AmclOptions& options, const Pose& motion, Rng& random, std::vector<Pose>& particles) {
  const std::array<double, 3> lengths{std::fabs(motion.x), std::fabs(motion.y), std::fabs(motion.a)};
  std::array<double, 3> errors{};  // standard deviations
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) errors[i] += options.drift[i][j] * lengths[j];
  for (Pose& particle : particles) {
    const Pose moved{motion.x + errors[0] * random.gaussian(), motion.y + errors[1] * random.gaussian(), 0,
                     motion.a + errors[2] * random.gaussian()};
    particle = geom::compose(particle, moved);
  }
}

/// Cumulated weights by how well the scan fits, and the mean likelihood of those that are not random: with
/// them a share of random particles, which fit badly, would keep itself up.
struct Weights {
  std::vector<double> cumulated;
  double mean = 0;
};

Weights weights_of(const LikelihoodField& field, const FilterIn& in, const FilterMemory& memory) {
  Weights weights;
  double most = -HUGE_VAL;
  for (const Pose& particle : memory.particles) {
    weights.cumulated.push_back(field.log_likelihood(particle, in.hits_R));
    most = std::max(most, weights.cumulated.back());
  }
  double sum = 0;
  for (double& weight : weights.cumulated) weight = sum += geom::exp(weight - most);
  const std::size_t judged = memory.particles.size() - memory.random;
  if (judged > 0)
    weights.mean = geom::exp(most) * weights.cumulated[judged - 1] / static_cast<double>(judged);
  return weights;
}

std::size_t pick(const Weights& weights, Rng& random) {
  const double at = random.uniform() * weights.cumulated.back();
  const auto found = std::ranges::upper_bound(weights.cumulated, at);
  return std::min(static_cast<std::size_t>(found - weights.cumulated.begin()), weights.cumulated.size() - 1);
}

/// Share of random particles; updates the averages.
double random_share(const AmclOptions& options, double likelihood, FilterMemory& memory) {
  if (memory.slow == 0) memory.slow = memory.fast = likelihood;
  memory.slow += options.slow_rate * (likelihood - memory.slow);
  memory.fast += options.fast_rate * (likelihood - memory.fast);
  return memory.slow > 0 ? std::max(0.0, 1 - memory.fast / memory.slow) : 0;
}

}  // namespace

bool is_possible(const PoseBelief& belief) {
  for (const double value : belief.cov)
    if (!std::isfinite(value)) return false;
  return std::isfinite(belief.mean.x) && std::isfinite(belief.mean.y) && std::isfinite(belief.mean.a) &&
         root_of(belief.cov).has_value();
}

FilterOut filter_step(const AmclOptions& options, const LikelihoodField& field, const FilterIn& in,
                      FilterMemory& memory) {
  Rng random(in.seed, in.number, {Purpose::kParticle});
  if (in.start) {
    const Root root = root_of(in.start->cov).value_or(Root{});
    memory = {};
    draw_enough(options, [&] {
      return memory.particles.emplace_back(drawn_on_floor(*in.start, root, field, random));
    });
  } else {
    move(options, in.motion, random, memory.particles);
  }
  const Weights weights = weights_of(field, in, memory);
  double share = in.hits_R.empty() ? 0 : random_share(options, weights.mean, memory);
  if (!field.has_free_cells()) share = 0;
  std::vector<Pose> kept{memory.particles[pick(weights, random)]}, lost;
  draw_enough(options, [&] {
    if (random.uniform() < share) return lost.emplace_back(random_pose(field, random));
    return kept.emplace_back(memory.particles[pick(weights, random)]);
  });
  FilterOut out{hypotheses_of(kept), {}};
  memory.random = lost.size();
  kept.insert(kept.end(), lost.begin(), lost.end());
  out.particles = memory.particles = std::move(kept);
  return out;
}

}  // namespace playhouse::drivers
