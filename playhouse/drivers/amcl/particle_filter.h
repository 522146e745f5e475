#pragma once

/// One step of Monte Carlo localization: from a motion and a scan to the poses that the robot may have.
/// A pure function; its arithmetic gives the same bits on every machine.
///
/// In: options, the likelihood field of a map, the motion by odometry since the previous step, what the
///   scanner hits; or a belief to begin anew with. The particles of the previous step.
///
/// Out: clusters of particles as hypotheses; the particles for the next step.
///
/// Cost: particles times hits; 10,000 particles with 30 hits take 5 ms, 500 0.4 ms.
///
/// Source: S. Thrun, W. Burgard, D. Fox: "Probabilistic Robotics", 2005, chapter 8: the particle filter, with
/// random particles while scans fit badly (table 8.3), and a number of particles by the spread of
/// the belief (KLD-sampling, D. Fox, 2003, table 8.4).

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "playhouse/drivers/amcl/likelihood_field.h"
#include "playhouse/geom/pose.h"

namespace playhouse::drivers {

/// A normal distribution of a pose. `cov`: xx, yy, aa, xy, ya, xa [m^2, rad^2, m rad].
struct PoseBelief {
  geom::Pose mean;
  std::array<double, 6> cov{};
};

/// False if the covariance is not positive semidefinite or a number is not finite.
bool is_possible(const PoseBelief& belief);

struct AmclOptions {
  std::size_t min_particles = 100, max_particles = 10000;
  double kld_error = 0.01;  // of the particles' distribution against the true one
  double kld_z = 3;         // standard normal quantile of the probability that the error is kept
  /// Standard deviations of a motion's error along x, y and of its heading, in
  /// the robot's frame, per metre along x, per metre along y and per radian.
  std::array<std::array<double, 3>, 3> drift{{{0.2, 0, 0}, {0, 0.2, 0}, {0.2, 0, 0.2}}};
  PoseBelief start{{}, {1, 1, geom::kTwoPi* geom::kTwoPi, 0, 0, 0}};
  double update_distance = 0.2, update_angle = geom::kPi / 6;  // m, rad; motion between two steps
  std::size_t max_beams = 30;                                  // of a scan
  double max_range = 8.192;                                    // m; longer ranges are misses
  SensorModel sensor;
  /// Rates of two averages of how well scans fit. While the fast one is below
  /// the slow one, that share of the particles is random, to find a robot that was carried away.
  double slow_rate = 0.001, fast_rate = 0.1;
};

struct FilterIn {
  std::uint64_t seed = 0, number = 0;  // of random numbers, and which step
  std::optional<PoseBelief> start;     // begins anew
  geom::Pose motion;                   // X_RoldRnew by odometry
  std::vector<geom::Vec2> hits_R;      // m
};

struct FilterMemory {
  std::vector<geom::Pose> particles;  // X_WR, of equal weight
  std::size_t random = 0;             // number of those at the end that no scan has judged yet
  double slow = 0, fast = 0;          // averages of likelihoods of the others
};

struct Hypothesis {
  PoseBelief belief;
  double weight = 0;  // all sum to 1
};

struct FilterOut {
  std::vector<Hypothesis> hypotheses;  // heaviest first, at least one; without random particles
  std::vector<geom::Pose> particles;   // X_WR, of equal weight
};

FilterOut filter_step(const AmclOptions& options, const LikelihoodField& field, const FilterIn& in,
                      FilterMemory& memory);

inline constexpr std::size_t kMostHypotheses = 64;

/// The particles in groups of neighbouring bins of 0.5 m and 10 degrees, the heaviest
/// first, kMostHypotheses at most; weights are shares of the particles of these groups.
std::vector<Hypothesis> hypotheses_of(std::span<const geom::Pose> particles);

}  // namespace playhouse::drivers
