/// A bumper as interface bumper (docs/drivers.md).

#include "playhouse/wire/generated/bumper.h"

#include "playhouse/bridge/generated/device_makers.h"
#include "playhouse/bridge/interfaces/pose_on_robot.h"
#include "playhouse/drivers/shapes.h"

namespace playhouse::drivers {
namespace {

namespace bumper = wire::bumper;
using wire::MessageType;

/// Poses of a bumper's switch faces on the robot.
bumper::Geom geometry(const world::World& world, world::ModelRow model) {
  const scene::BumperDesc& desc = *world.desc(model).bumper;
  const geom::SpatialPose X_RB = pose_on_robot(world, model);
  bumper::Geom geom;
  for (std::size_t k = 0; k < desc.X_BS.size(); ++k)
    geom.bumper_def.push_back(
        {pose3d(geom::compose(X_RB, {desc.X_BS[k], {}})), static_cast<float>(desc.blength[k]), 0});
  return geom;
}

class Bumper final : public SimulatedDevice {
 public:
  Bumper(run::Simulation& simulation, world::ModelRow model)
      : SimulatedDevice(simulation, simulation.world().id(model)),
        geometry_(wire::encode(geometry(simulation.world(), model))) {}

  std::span<const Served> served() const override {
    static constexpr Served kServed[] = {{MessageType::kReq, bumper::kReqGetGeom}};
    return kServed;
  }
  void request(const device::Message&, device::Replier replier) override { replier.ack(geometry_); }

  void emit(const world::World& world, std::vector<device::Publication>& out) override {
    const world::ModelRow row = world.row(model());
    if (!row) return;
    const world::BumperRow switches = world.models.part[row];
    if (world.bumpers.measured_tick[switches] != world.tick()) return;
    bumper::Data data;
    for (const world::ModelId hit : world.bumpers.hits[switches]) data.bumpers.push_back(hit ? 1 : 0);
    publish(world, bumper::kDataState, data, out);
  }

 private:
  Bytes geometry_;
};

}  // namespace

std::unique_ptr<SimulatedDevice> make_bumper_device(run::Simulation& simulation, world::ModelRow model) {
  return std::make_unique<Bumper>(simulation, model);
}

}  // namespace playhouse::drivers
