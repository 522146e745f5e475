/// A GNSS receiver as interface gps (docs/drivers.md).

#include "playhouse/wire/generated/gps.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "playhouse/bridge/generated/device_makers.h"
#include "playhouse/drivers/geodesy.h"

namespace playhouse::drivers {
namespace {

namespace gps = wire::gps;

constexpr std::uint32_t kLeastSatellites = 4;  // minimum for a 3D fix

std::int32_t whole(double value) {
  constexpr double kLeast = std::numeric_limits<std::int32_t>::min(),
                   kMost = std::numeric_limits<std::int32_t>::max();
  return static_cast<std::int32_t>(std::clamp(std::round(value), kLeast, kMost));
}

/// Course: clockwise from north, in [0, 2 pi).  [rad]
double course_of(const geom::Vec3& velocity) {
  const double course = std::atan2(velocity.x, velocity.y);
  return course < 0 ? course + geom::kTwoPi : course;
}

class Gps final : public SimulatedDevice {
 public:
  Gps(run::Simulation& simulation, world::ModelRow model)
      : SimulatedDevice(simulation, simulation.world().id(model)) {}

  std::span<const Served> served() const override { return {}; }
  void request(const device::Message&, device::Replier) override {}

  void emit(const world::World& world, std::vector<device::Publication>& out) override {
    const world::ModelRow row = world.row(model());
    if (!row) return;
    const world::GpsRow receiver = world.models.part[row];
    if (world.receivers.measured_tick[receiver] != world.tick()) return;
    publish(world, gps::kDataState, fix(world, world.desc(row), receiver), out);
  }

 private:
  static gps::Data fix(const world::World& world, const scene::ModelDesc& desc, world::GpsRow receiver);
};

gps::Data Gps::fix(const world::World& world, const scene::ModelDesc& desc, world::GpsRow receiver) {
  const scene::GpsDesc& limits = *desc.gps;
  gps::Data data;
  const auto micros = static_cast<std::uint64_t>(std::llround(world.time() * 1e6));
  data.time_sec = static_cast<std::uint32_t>(micros / 1000000);
  data.time_usec = static_cast<std::uint32_t>(micros % 1000000);
  data.num_sats = limits.satellites;
  data.hdop = static_cast<std::uint32_t>(std::lround(10 * limits.hdop));
  data.vdop = static_cast<std::uint32_t>(std::lround(10 * limits.vdop));
  if (limits.satellites < kLeastSatellites) return data;  // quality 0: no fix
  const scene::SceneDesc& scene = world.scene();
  const geom::Vec3 &p = world.receivers.position[receiver], &v = world.receivers.velocity[receiver];
  const Geodetic place = place_on_earth({scene.latitude, scene.longitude, scene.altitude}, p.x, p.y, p.z);
  const Utm utm = utm_of(place);
  data.latitude = whole(geom::degrees(place.latitude) * 1e7);
  data.longitude = whole(geom::degrees(place.longitude) * 1e7);
  data.altitude = whole(place.height * 1e3);
  data.speed = std::hypot(v.x, v.y);
  data.course = course_of(v);
  data.utm_e = utm.easting;
  data.utm_n = utm.northing;
  data.quality = 1;
  data.err_horz = std::sqrt(2.0) * std::hypot(limits.noise_horizontal, limits.drift_horizontal);
  data.err_vert = std::hypot(limits.noise_vertical, limits.drift_vertical);
  return data;
}

}  // namespace

std::unique_ptr<SimulatedDevice> make_gps_device(run::Simulation& simulation, world::ModelRow model) {
  return std::make_unique<Gps>(simulation, model);
}

}  // namespace playhouse::drivers
