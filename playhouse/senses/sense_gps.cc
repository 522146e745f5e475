/// GpsSense: the phase in which GNSS receivers that are subscribed and due measure.
///
/// In: poses of models; the error parameters of each receiver; its state at the previous measurement.
/// Out: measured position and velocity in W.
/// Cost: a hundred random numbers for a receiver with noise.
/// Source: errors are white noise and a Gauss-Markov process of first order, x(t + dt) = b x(t) + sqrt(1 -
/// b^2) s n
///   with b = exp(-dt / T), deviation s and time T (Brown and Hwang, "Introduction to Random Signals and
///   Applied Kalman Filtering", 2012, 3.6; Rankin, "An error model for sensor simulation GPS and differential
///   GPS", 1994).

#include <algorithm>
#include <cmath>

#include "playhouse/base/rng.h"
#include "playhouse/senses/generated/senses.h"
#include "playhouse/senses/pose_sense.h"

namespace playhouse::senses {
namespace {

using geom::Vec3;

/// exp(-x) for x >= 0, from multiplications alone: the same bits everywhere. Error below 1e-12.
double decay(double x) {
  constexpr double kAll = 700;  // the result is below the smallest significant value
  if (x > kAll) return 0;
  int halvings = 0;
  for (; x > 0.125; x *= 0.5) ++halvings;
  double sum = 1;
  for (int n = 10; n > 0; --n) sum = 1 - x / n * sum;
  for (; halvings > 0; --halvings) sum *= sum;
  return sum;
}

Vec3 gaussian(Rng& rng, double horizontal, double vertical) {
  if (horizontal == 0 && vertical == 0) return {0, 0, 0};
  const double x = rng.gaussian(), y = rng.gaussian(), z = rng.gaussian();
  return {horizontal * x, horizontal * y, vertical * z};
}

class GpsSense final : public PoseSense {
 public:
  SensorTable table(world::World& world) const override {
    return {world.receivers.model, world.receivers.measured_tick};
  }

 private:
  void measure(world::World& world, world::KindRow row, std::uint64_t tick) const override;
};

void GpsSense::measure(world::World& world, world::KindRow row, std::uint64_t tick) const {
  world::Receivers& receivers = world.receivers;
  const world::ModelRow model = receivers.model[row];
  const scene::GpsDesc& gps = *world.desc(model).gps;
  const geom::SpatialPose X_WB = body_pose(world, model);
  const Vec3 p{X_WB.X.x, X_WB.X.y, X_WB.X.z};
  Rng rng(world.seed(), tick, {Purpose::kFix, world.serial(model)});
  const bool is_first = receivers.noted_tick[row] == 0;
  const double dt = static_cast<double>(tick - receivers.noted_tick[row]) * world.scene().interval;
  const double kept = is_first ? 0 : decay(dt / gps.drift_time), drawn = std::sqrt(1 - kept * kept);
  receivers.drift[row] =
      kept * receivers.drift[row] + gaussian(rng, drawn * gps.drift_horizontal, drawn * gps.drift_vertical);
  receivers.position[row] =
      p + receivers.drift[row] + gaussian(rng, gps.noise_horizontal, gps.noise_vertical);
  const Vec3 moved = is_first ? Vec3{} : (1 / dt) * (p - receivers.p_WB[row]);
  receivers.velocity[row] = moved + gaussian(rng, gps.velocity_noise, gps.velocity_noise);
  receivers.p_WB[row] = p;
  receivers.noted_tick[row] = tick;
}

}  // namespace

std::unique_ptr<SensePhase> make_gps_sense(unsigned) {
  return std::make_unique<GpsSense>();
}

}  // namespace playhouse::senses
