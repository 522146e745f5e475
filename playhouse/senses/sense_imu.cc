/// ImuSense: the phase in which inertial measurement units that are
/// subscribed and due measure the motion since their previous measurement.
///
/// In: poses of models; the error parameters of each unit; its state at the previous measurement.
/// Out: specific force and angular rates with errors, and the unit's own estimate of its pose.
/// Cost: a hundred random numbers for a unit with noise.
/// Source: specific force is acceleration minus gravity, in the body frame; force and rates are means over
///   the interval, so that integrating them gives the true motion. White noise of density N then has the
///   standard deviation N / sqrt(dt), and a bias random walk of density K moves by K sqrt(dt) (IEEE Std 952,
///   annex C). Levelling by accelerometers has an error of bias / g, heading the integral of the gyroscope's
///   error about the vertical (Groves, "Principles of GNSS, Inertial, and Multisensor Integrated Navigation
///   Systems", 2013, 5.6). Poses are those of ticks, so the acceleration lags by one interval: it is that of
///   the previous measurement.

#include <algorithm>
#include <cmath>

#include "playhouse/base/rng.h"
#include "playhouse/senses/generated/senses.h"
#include "playhouse/senses/pose_sense.h"

namespace playhouse::senses {
namespace {

using geom::Quaternion;
using geom::Vec3;

Quaternion inverse(const Quaternion& q) {
  return {q.w, -q.x, -q.y, -q.z};
}

/// Rotation vector (axis times angle) of the shorter rotation.  [rad]
Vec3 turn_of(const Quaternion& q) {
  const double sign = q.w < 0 ? -1 : 1, sine = std::sqrt(q.x * q.x + q.y * q.y + q.z * q.z);
  const double scale = sine > 0 ? sign * 2 * geom::atan2(sine, sign * q.w) / sine : 2;
  return {scale * q.x, scale * q.y, scale * q.z};
}

Quaternion about(const Vec3& turn) {
  const double angle = std::sqrt(dot(turn, turn));
  const geom::SinCos half = geom::sincos(0.5 * angle);
  const double scale = angle > 0 ? half.sin / angle : 0.5;
  return {half.cos, scale * turn.x, scale * turn.y, scale * turn.z};
}

Vec3 gaussian(Rng& rng, double deviation) {
  if (deviation == 0) return {};
  const double x = rng.gaussian(), y = rng.gaussian(), z = rng.gaussian();
  return {deviation * x, deviation * y, deviation * z};
}

Vec3 within(const Vec3& v, double most) {
  return {std::clamp(v.x, -most, most), std::clamp(v.y, -most, most), std::clamp(v.z, -most, most)};
}

class ImuSense final : public PoseSense {
 public:
  SensorTable table(world::World& world) const override {
    return {world.imus.model, world.imus.measured_tick};
  }

 private:
  void measure(world::World& world, world::KindRow row, std::uint64_t tick) const override;
  static void begin(world::World& world, world::ImuRow row, const geom::SpatialPose& X_WB, Rng& rng);
  static void believe(world::World& world, world::ImuRow row, double dt, const Quaternion& q_WB,
                      const Vec3& f, double turn_error);
};

/// First measurement: assumes that the unit has moved at its present velocity.
void ImuSense::begin(world::World& world, world::ImuRow row, const geom::SpatialPose& X_WB, Rng& rng) {
  world::Imus& imus = world.imus;
  const scene::ImuDesc& imu = *world.desc(imus.model[row]).imu;
  const Vec3 p{X_WB.X.x, X_WB.X.y, X_WB.X.z};
  const Vec3 v = velocity_at(world, world.models.root[imus.model[row]], p);
  const Vec3 before = p - world.scene().interval * v;
  imus.X_WB[row] = {before.x, before.y, before.z, X_WB.X.a};
  imus.tilt_WB[row] = X_WB.tilt;
  imus.X_WE[row] = imus.X_WB[row];
  imus.v_WB[row] = imus.v_WE[row] = v;
  imus.bias[row] = {gaussian(rng, imu.acceleration_bias), gaussian(rng, imu.gyro_bias)};
  imus.heading_error[row] = 0;
}

void ImuSense::measure(world::World& world, world::KindRow row, std::uint64_t tick) const {
  world::Imus& imus = world.imus;
  const world::ModelRow model = imus.model[row];
  const scene::ImuDesc& imu = *world.desc(model).imu;
  const geom::SpatialPose X_WB = body_pose(world, model);
  Rng rng(world.seed(), tick, {Purpose::kInertia, world.serial(model)});
  const bool is_first = imus.noted_tick[row] == 0;
  const std::uint64_t ticks = is_first ? 1 : tick - imus.noted_tick[row];
  if (is_first) begin(world, row, X_WB, rng);
  const double dt = static_cast<double>(ticks) * world.scene().interval;
  const geom::Pose& before = imus.X_WB[row];
  const Quaternion q_WA = geom::orientation(before.a, imus.tilt_WB[row]),
                   q_WB = geom::orientation(X_WB.X.a, X_WB.tilt);
  const double gravity = world.scene().gravity;
  const Vec3 v = (1 / dt) * (Vec3{X_WB.X.x, X_WB.X.y, X_WB.X.z} - Vec3{before.x, before.y, before.z});
  const Vec3 acceleration = (1 / dt) * (v - imus.v_WB[row]);
  const Vec3 w = (1 / dt) * turn_of(inverse(q_WA) * q_WB);
  const Vec3 f = inverse(q_WA) * (acceleration + Vec3{0, 0, gravity});

  const double per_root = 1 / std::sqrt(dt), root = std::sqrt(dt);
  geom::SpatialVelocity& bias = imus.bias[row];
  bias.v = bias.v + gaussian(rng, imu.acceleration_walk * root);
  bias.w = bias.w + gaussian(rng, imu.gyro_walk * root);
  const Vec3 f_read = within(f + bias.v + gaussian(rng, imu.acceleration_white * per_root),
                             imu.acceleration_range),
             w_read = within(w + bias.w + gaussian(rng, imu.gyro_white * per_root), imu.gyro_range);
  imus.reading[row] = {f_read, w_read};
  believe(world, row, dt, q_WA, f_read, (q_WB * (w_read - w)).z);
  imus.X_WB[row] = X_WB.X;
  imus.tilt_WB[row] = X_WB.tilt;
  imus.v_WB[row] = v;
  imus.noted_tick[row] = tick;
  // Attitude estimate: roll and pitch from the accelerometers,
  // if there is gravity, yaw from the gyroscopes.
  const Vec3 level_error = gravity > 0 ? (1 / gravity) * Vec3{bias.v.y, -bias.v.x, 0} : Vec3{};
  const Quaternion q_WE = about({0, 0, imus.heading_error[row]}) * q_WB * about(level_error);
  const geom::SpatialPose X_WE = geom::spatial_pose({}, q_WE);
  imus.X_WE[row].a = X_WE.X.a;
  imus.tilt_WE[row] = X_WB.tilt == geom::Tilt{} && bias.v == Vec3{} ? geom::Tilt{} : X_WE.tilt;
}

/// Dead reckoning: integrates the specific force; velocities first, as readings are their differences.
void ImuSense::believe(world::World& world, world::ImuRow row, double dt, const Quaternion& q_WA,
                       const Vec3& f, double turn_error) {
  world::Imus& imus = world.imus;
  const Quaternion q_WE = about({0, 0, imus.heading_error[row]}) * q_WA;
  const Vec3 v = imus.v_WE[row] + dt * (q_WE * f - Vec3{0, 0, world.scene().gravity});
  imus.v_WE[row] = v;
  geom::Pose& X = imus.X_WE[row];
  X.x += dt * v.x;
  X.y += dt * v.y;
  X.z += dt * v.z;
  imus.heading_error[row] = geom::normalize(imus.heading_error[row] + dt * turn_error);
}

}  // namespace

std::unique_ptr<SensePhase> make_imu_sense(unsigned) {
  return std::make_unique<ImuSense>();
}

}  // namespace playhouse::senses
