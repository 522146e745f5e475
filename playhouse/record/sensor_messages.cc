#include "playhouse/record/sensor_messages.h"

#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <vector>

#include "playhouse/record/frames.h"
#include "playhouse/record/messages.h"
#include "playhouse/record/on_earth.h"
#include "playhouse/scene/forms/camera.h"
#include "playhouse/scene/forms/sensor_rays.h"
#include "playhouse/world/periods.h"

namespace playhouse::record {
namespace {

using geom::Quaternion;
using geom::Vec3;

void put_vector(CdrWriter& out, const Vec3& v) {
  out.numbers(std::array{v.x, v.y, v.z});
}

void put_quaternion(CdrWriter& out, const Quaternion& q) {
  out.numbers(std::array{q.x, q.y, q.z, q.w});
}

/// A covariance of independent components with this variance each; all 0 is unknown.
template <std::size_t kRows>
void put_covariance(CdrWriter& out, double variance) {
  std::array<double, kRows * kRows> covariance{};
  for (std::size_t i = 0; i < kRows; ++i) covariance[i * (kRows + 1)] = variance;
  out.numbers(covariance);
}

/// Velocity of a robot in its own frame, as interface position3d has it: in 3D of its body, else as driven.
geom::SpatialVelocity velocity_of(const world::World& world, world::ModelRow model) {
  if (world.upright) {
    const geom::Twist& driven = world.positions.velocity[world.models.part[model]];
    return {{driven.x, driven.y, driven.z}, {0, 0, driven.a}};
  }
  const Quaternion q = geom::orientation(world.models.X_WM[model].a, world.models.tilt_WM[model]);
  const Quaternion q_MW{q.w, -q.x, -q.y, -q.z};
  const geom::SpatialVelocity& V = world.models.V_WM[model];
  return {q_MW * V.v, q_MW * V.w};
}

/// The points of a sensor's beams, row by row.
class Cloud {
 public:
  explicit Cloud(const scene::RangerSensorDesc& sensor)
      : sensor_(sensor), width_(sensor.samples - (repeats_first_beam(sensor) ? 1 : 0)) {}

  /// Of all beams of all rings.
  void add(std::span<const float> ranges, std::span<const float> intensities) {
    for (std::uint32_t ring = 0; ring < sensor_.rings; ++ring)
      for (std::uint32_t k = 0; k < width_; ++k) {
        const std::size_t beam = std::size_t{ring} * sensor_.samples + k;
        add_point(ring, k, ranges[beam], intensities[beam]);
      }
  }
  void put(CdrWriter& out) const;

 private:
  static constexpr std::uint32_t kPointBytes = 18;  // four float32, one uint16
  static constexpr std::uint8_t kUint16 = 4, kFloat32 = 7;

  void add_point(std::uint32_t ring, std::uint32_t k, float range, float intensity);
  template <typename Number>
  void add_number(Number value) {
    put_bytes(data_, std::as_bytes(std::span(&value, 1)));
  }

  const scene::RangerSensorDesc& sensor_;
  const std::uint32_t width_;
  Bytes data_;
  bool is_dense_ = true;
};

void Cloud::add_point(std::uint32_t ring, std::uint32_t k, float range, float intensity) {
  const bool is_near = sensor_.range_min > 0 && range <= static_cast<float>(sensor_.range_min);
  const bool is_seen = range < static_cast<float>(sensor_.range_max) && !is_near;
  is_dense_ = is_dense_ && is_seen;
  const auto reach = is_seen ? static_cast<double>(range) : std::numeric_limits<double>::quiet_NaN();
  const geom::SinCos across = geom::sincos(scene::bearing_of(sensor_, k)),
                     up = geom::sincos(scene::elevation_of(sensor_, ring));
  const Vec3 p = reach * Vec3{up.cos * across.cos, up.cos * across.sin, up.sin};
  // Beams start at half the sensor's height above its frame.
  for (const double number : {p.x, p.y, p.z + 0.5 * sensor_.size.z}) add_number(static_cast<float>(number));
  add_number(intensity);
  add_number(static_cast<std::uint16_t>(ring));
}

void Cloud::put(CdrWriter& out) const {
  out.number(sensor_.rings);
  out.number(width_);
  constexpr std::array kFields{"x", "y", "z", "intensity", "ring"};
  out.count(kFields.size());
  for (std::uint32_t i = 0; i < kFields.size(); ++i) {
    out.text(kFields[i]);
    out.number(i * static_cast<std::uint32_t>(sizeof(float)));
    out.number(i + 1 < kFields.size() ? kFloat32 : kUint16);
    out.number(std::uint32_t{1});
  }
  out.number(false);  // is_bigendian
  out.number(kPointBytes);
  out.number(kPointBytes * width_);
  out.bytes(data_);
  out.number(is_dense_);
}

}  // namespace

Bytes odometry_message(std::uint64_t ns, const std::string& frame, const std::string& child,
                       const world::World& world, world::ModelRow model) {
  constexpr std::size_t kDegrees = 6;  // of freedom
  const geom::SpatialPose X = estimated_pose(world, model);
  const geom::SpatialVelocity V = velocity_of(world, model);
  CdrWriter out;
  put_header(out, ns, frame);
  out.text(child);
  put_vector(out, {X.X.x, X.X.y, X.X.z});
  put_quaternion(out, geom::orientation(X.X.a, X.tilt));
  put_covariance<kDegrees>(out, 0);
  put_vector(out, V.v);
  put_vector(out, V.w);
  put_covariance<kDegrees>(out, 0);
  return out.message();
}

Bytes imu_message(std::uint64_t ns, const std::string& frame, const world::World& world,
                  world::ModelRow model) {
  constexpr std::size_t kAxes = 3;
  const world::KindRow row = world.models.part[model];
  const scene::ImuDesc& desc = *world.desc(model).imu;
  const auto& [force, turn] = world.imus.reading[row];
  // White noise, the mean over a period of which is measured.
  const double period = static_cast<double>(world::update_ticks(world, model)) * world.scene().interval;
  CdrWriter out;
  put_header(out, ns, frame);
  put_quaternion(out, geom::orientation(world.imus.X_WE[row].a, world.imus.tilt_WE[row]));
  put_covariance<kAxes>(out, 0);
  put_vector(out, turn);
  put_covariance<kAxes>(out, desc.gyro_white * desc.gyro_white / period);
  put_vector(out, force);
  put_covariance<kAxes>(out, desc.acceleration_white * desc.acceleration_white / period);
  return out.message();
}

Bytes fix_message(std::uint64_t ns, const std::string& frame, const world::World& world,
                  world::ModelRow model) {
  constexpr std::uint32_t kLeastSatellites = 4;  // as interface gps
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  const scene::GpsDesc& desc = *world.desc(model).gps;
  const scene::SceneDesc& scene = world.scene();
  const bool has_fix = desc.satellites >= kLeastSatellites;
  const GeodeticPosition place = has_fix ? on_earth({scene.latitude, scene.longitude, scene.altitude},
                                                    world.receivers.position[world.models.part[model]])
                                         : GeodeticPosition{kNone, kNone, kNone};
  const auto variance = [](double noise, double drift) { return noise * noise + drift * drift; };
  const double level = variance(desc.noise_horizontal, desc.drift_horizontal);
  const double upright = variance(desc.noise_vertical, desc.drift_vertical);
  CdrWriter out;
  put_header(out, ns, frame);
  out.number(static_cast<std::int8_t>(has_fix ? 0 : -1));
  out.number(std::uint16_t{1});  // of GPS
  out.numbers(std::array{geom::degrees(place.latitude), geom::degrees(place.longitude), place.height});
  out.numbers(std::array{level, 0.0, 0.0, 0.0, level, 0.0, 0.0, 0.0, upright});
  out.number(static_cast<std::uint8_t>(has_fix ? 2 : 0));  // variances are known, or nothing is
  return out.message();
}

Bytes camera_info_message(std::uint64_t ns, const std::string& frame, const world::World& world,
                          world::ModelRow model) {
  const scene::CameraDesc& camera = *world.desc(model).camera;
  const scene::HalfImage half = scene::half_image(camera, world.cameras.zoom[world.models.part[model]]);
  const double fx = 0.5 * camera.width / half.width, fy = 0.5 * camera.height / half.height;
  // Whole numbers are the middles of pixels.
  const double cx = 0.5 * (camera.width - 1), cy = 0.5 * (camera.height - 1);
  constexpr std::array<double, 5> kNone{};
  CdrWriter out;
  put_header(out, ns, frame);
  out.number(static_cast<std::uint32_t>(camera.height));
  out.number(static_cast<std::uint32_t>(camera.width));
  out.text("plumb_bob");
  out.count(kNone.size());
  out.numbers(kNone);
  out.numbers(std::array{fx, 0.0, cx, 0.0, fy, cy, 0.0, 0.0, 1.0});
  out.numbers(std::array{1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0});
  out.numbers(std::array{fx, 0.0, cx, 0.0, 0.0, fy, cy, 0.0, 0.0, 0.0, 1.0, 0.0});
  for (int i = 0; i < 6; ++i) out.number(std::uint32_t{0});  // binning, region of interest: the whole image
  out.number(false);                                         // do_rectify
  return out.message();
}

Bytes cloud_message(std::uint64_t ns, const std::string& frame, const world::World& world,
                    world::ModelRow model, std::uint32_t sensor) {
  const std::vector<scene::RangerSensorDesc>& sensors = world.desc(model).sensors;
  const world::RangerRow ranger = world.models.part[model];
  const auto beams_of = [](const scene::RangerSensorDesc& each) {
    return each.rings > 1 ? std::size_t{each.samples} * each.rings : 0;
  };
  std::size_t first = 0;
  for (std::uint32_t i = 0; i < sensor; ++i) first += beams_of(sensors[i]);
  const std::size_t count = beams_of(sensors[sensor]);
  const std::span<const float> ranges(world.rangers.ring_ranges[ranger]),
      intensities(world.rangers.ring_intensities[ranger]);
  if (ranges.size() < first + count || intensities.size() < first + count) return {};
  Cloud cloud(sensors[sensor]);
  cloud.add(ranges.subspan(first, count), intensities.subspan(first, count));
  CdrWriter out;
  put_header(out, ns, frame);
  cloud.put(out);
  return out.message();
}

}  // namespace playhouse::record
