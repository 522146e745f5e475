/// A camera as interface ptz (docs/drivers.md).

#include "playhouse/wire/generated/ptz.h"

#include <cmath>

#include "playhouse/bridge/generated/device_makers.h"
#include "playhouse/bridge/interfaces/pose_on_robot.h"
#include "playhouse/drivers/shapes.h"
#include "playhouse/world/periods.h"

namespace playhouse::drivers {
namespace {

namespace changes = world::changes;
namespace ptz = wire::ptz;
using wire::MessageType;

class Ptz final : public SimulatedDevice {
 public:
  Ptz(run::Simulation& simulation, world::ModelRow model)
      : SimulatedDevice(simulation, simulation.world().id(model)),
        update_ticks_(world::update_ticks(simulation.world(), model)) {
    const world::World& world = simulation.world();
    geometry_ = wire::encode(ptz::Geom{pose3d(pose_on_robot(world, model)), bbox3d(world.desc(model).size)});
  }

  world::ModelId robot() const override { return model(); }
  std::span<const Served> served() const override {
    static constexpr Served kServed[] = {
        {MessageType::kCmd, ptz::kCmdState},
        {MessageType::kReq, ptz::kReqControlMode},
        {MessageType::kReq, ptz::kReqGeom},
        {MessageType::kReq, ptz::kReqStatus},
    };
    return kServed;
  }

  device::Taken command(const device::Message& message) override {
    const auto wanted = wire::decode<ptz::Cmd>(message.body);
    if (!wanted || !are_finite(*wanted)) return device::Taken::kNo;
    simulation().requests().command(changes::PointCamera{model(), wanted->pan, wanted->tilt, wanted->zoom,
                                                         wanted->panspeed, wanted->tiltspeed});
    return device::Taken::kLatest;
  }

  void request(const device::Message& message, device::Replier replier) override {
    switch (message.subtype) {
      case ptz::kReqGeom:
        replier.ack(geometry_);
        return;
      case ptz::kReqStatus:
        replier.ack(wire::encode(ptz::ReqStatus{}));
        return;
      default:  // CONTROL_MODE
        if (const auto value = wire::decode<ptz::ReqControlMode>(message.body);
            value && (value->mode == ptz::kVelocityControl || value->mode == ptz::kPositionControl))
          change_world(std::move(replier),
                       changes::ControlCamera{model(), value->mode == ptz::kVelocityControl});
        return;
    }
  }

  void emit(const world::World& world, std::vector<device::Publication>& out) override {
    if (world.tick() % update_ticks_ != 0) return;
    const world::ModelRow row = world.row(model());
    if (!row) return;
    const world::Cameras& cameras = world.cameras;
    const world::CameraRow camera = world.models.part[row];
    ptz::Data data;
    data.pan = static_cast<float>(cameras.pan[camera]);
    data.tilt = static_cast<float>(cameras.tilt[camera]);
    data.zoom = static_cast<float>(cameras.zoom[camera]);
    data.panspeed = static_cast<float>(cameras.pan_speed[camera]);
    data.tiltspeed = static_cast<float>(cameras.tilt_speed[camera]);
    publish(world, ptz::kDataState, data, out);
  }

  /// Resets to position control for the next client.
  void closed(world::Journal& journal) override { journal.apply(changes::ControlCamera{model(), false}); }

 private:
  static bool are_finite(const ptz::Cmd& wanted) {
    return std::isfinite(wanted.pan) && std::isfinite(wanted.tilt) && std::isfinite(wanted.zoom) &&
           std::isfinite(wanted.panspeed) && std::isfinite(wanted.tiltspeed);
  }

  std::uint64_t update_ticks_;
  Bytes geometry_;
};

}  // namespace

std::unique_ptr<SimulatedDevice> make_ptz_device(run::Simulation& simulation, world::ModelRow model) {
  return std::make_unique<Ptz>(simulation, model);
}

}  // namespace playhouse::drivers
