/// A gripper as interface gripper (docs/drivers.md).

#include "playhouse/wire/generated/gripper.h"

#include "playhouse/bridge/generated/device_makers.h"
#include "playhouse/bridge/interfaces/pose_on_robot.h"
#include "playhouse/drivers/shapes.h"
#include "playhouse/scene/forms/gripper_body.h"
#include "playhouse/world/gripper.h"

namespace playhouse::drivers {
namespace {

namespace grip = wire::gripper;
using wire::MessageType;
using world::GripperCommand;
using world::PaddleState;

constexpr std::uint32_t kBeams = 2, kFirstBeam = 4;  // bits of beams start there, inner beam first

std::uint8_t state_of(PaddleState state) {
  switch (state) {
    case PaddleState::kOpen:
      return grip::kStateOpen;
    case PaddleState::kClosed:
      return grip::kStateClosed;
    case PaddleState::kMoving:
      return grip::kStateMoving;
    case PaddleState::kStopped:
      return grip::kStateError;
  }
  return grip::kStateError;
}

/// Size of the gap between open paddles.
geom::Size gap_of(const scene::ModelDesc& desc) {
  const scene::GripperDesc& gripper = *desc.gripper;
  return {gripper.paddle_length * desc.size.x, 2 * scene::paddle_face(gripper, desc.size, 0),
          gripper.paddle_height * desc.size.z};
}

class Gripper final : public SimulatedDevice {
 public:
  Gripper(run::Simulation& simulation, world::ModelRow model)
      : SimulatedDevice(simulation, simulation.world().id(model)) {
    const world::World& world = simulation.world();
    const scene::ModelDesc& desc = world.desc(model);
    geometry_ = wire::encode(
        grip::Geom{pose3d(pose_on_robot(world, model)), bbox3d(desc.size), bbox3d(gap_of(desc)), kBeams, 0});
  }

  world::ModelId robot() const override { return model(); }

  std::span<const Served> served() const override {
    static constexpr Served kServed[] = {
        {MessageType::kCmd, grip::kCmdOpen},
        {MessageType::kCmd, grip::kCmdClose},
        {MessageType::kCmd, grip::kCmdStop},
        {MessageType::kReq, grip::kReqGetGeom},
    };
    return kServed;
  }

  device::Taken command(const device::Message& message) override {
    const GripperCommand command = message.subtype == grip::kCmdOpen    ? GripperCommand::kOpen
                                   : message.subtype == grip::kCmdClose ? GripperCommand::kClose
                                                                        : GripperCommand::kStop;
    simulation().requests().command(world::changes::Grip{model(), command});
    return device::Taken::kLatest;
  }

  void request(const device::Message&, device::Replier replier) override { replier.ack(geometry_); }

  void emit(const world::World& world, std::vector<device::Publication>& out) override {
    const world::ModelRow row = world.row(model());
    if (!row) return;
    const world::GripperRow gripper = world.models.part[row];
    if (world.grippers.measured_tick[gripper] != world.tick()) return;
    const std::uint32_t beams = world.grippers.beams[gripper] * kFirstBeam;
    publish(world, grip::kDataState,
            grip::Data{state_of(world::paddle_state(world.grippers, gripper)), beams, 0}, out);
  }

 private:
  Bytes geometry_;
};

}  // namespace

std::unique_ptr<SimulatedDevice> make_gripper_device(run::Simulation& simulation, world::ModelRow model) {
  return std::make_unique<Gripper>(simulation, model);
}

}  // namespace playhouse::drivers
