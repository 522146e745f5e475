/// A detector as interface ranger, by beam, and as
/// interface fiducial, by detection (docs/detectors.md).

#include "playhouse/bridge/interfaces/pose_on_robot.h"
#include "playhouse/bridge/interfaces/ranging/fiducial.h"
#include "playhouse/bridge/interfaces/ranging/ranger.h"
#include "playhouse/drivers/shapes.h"
#include "playhouse/world/periods.h"

namespace playhouse::drivers {
namespace {

namespace fid = wire::fiducial;
namespace rng = wire::ranger;

/// Row of a detector, if it measured in this very tick; else none.
world::DetectorRow fresh_row(const world::World& world, world::ModelId id) {
  const world::ModelRow model = world.row(id);
  if (!model) return {};
  const world::DetectorRow row = world.models.part[model];
  if (world.detectors.measured_tick[row] != world.tick()) return {};
  return row;
}

rng::Geom geometry(const world::World& world, world::ModelRow model) {
  const scene::ModelDesc& desc = world.desc(model);
  return {
      pose3d(pose_on_robot(world, model)), bbox3d(desc.size), {pose3d(geom::Pose{})}, {bbox3d(desc.size)}};
}

/// Beams point at the centres of equal shares of the field of view, rightmost first.
ScanSource source_of(const world::World& world, world::ModelRow model) {
  const scene::DetectorDesc& detector = *world.desc(model).detector;
  const double share = detector.fov / detector.samples;
  ScanSource source{{}, static_cast<std::uint32_t>(detector.samples), world::update_ticks(world, model)};
  source.usual.min_angle = 0.5 * (share - detector.fov);
  source.usual.max_angle = 0.5 * (detector.fov - share);
  source.usual.resolution = share;
  source.usual.min_range = detector.range_min;
  source.usual.max_range = detector.range_max;
  source.usual.range_res = detector.resolution;
  source.usual.frequency = measuring_frequency(world, model);
  return source;
}

class DetectorRanger final : public RangerDevice {
 public:
  DetectorRanger(run::Simulation& simulation, world::ModelRow model)
      : RangerDevice(simulation, model, geometry(simulation.world(), model),
                     source_of(simulation.world(), model)) {}

 private:
  bool read(const world::World& world, std::vector<Reading>& out) const override {
    const world::DetectorRow row = fresh_row(world, model());
    out.clear();
    if (!row) return false;
    for (const world::Echo& echo : world.detectors.echoes[row])
      out.push_back({static_cast<double>(echo.range), static_cast<double>(echo.level)});
    return true;
  }
};

FovSettings field_of_view(const world::World& world, world::ModelRow model) {
  const scene::DetectorDesc& detector = *world.desc(model).detector;
  return {detector.range_min, detector.range_max, detector.fov};
}

class DetectorFiducial final : public FiducialDevice {
 public:
  DetectorFiducial(run::Simulation& simulation, world::ModelRow model)
      : FiducialDevice(simulation, model, field_of_view(simulation.world(), model)) {}

 private:
  std::optional<fid::Data> read(const world::World& world) const override {
    const world::DetectorRow row = fresh_row(world, model());
    if (!row) return std::nullopt;
    fid::Data data;
    for (const world::Detection& found : world.detectors.finds[row])
      data.fiducials.push_back(fiducial_item(found.number, found.range, found.bearing, 0));
    return data;
  }
};

}  // namespace

std::unique_ptr<SimulatedDevice> make_detector_ranger_device(run::Simulation& simulation,
                                                             world::ModelRow model) {
  return std::make_unique<DetectorRanger>(simulation, model);
}

std::unique_ptr<SimulatedDevice> make_detector_fiducial_device(run::Simulation& simulation,
                                                               world::ModelRow model) {
  return std::make_unique<DetectorFiducial>(simulation, model);
}

}  // namespace playhouse::drivers
