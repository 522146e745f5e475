/// A camera as interface camera (docs/drivers.md).

#include "playhouse/drivers/generated/device_makers.h"
#include "playhouse/drivers/interfaces/vision/image.h"

namespace playhouse::drivers {
namespace {

namespace cam = wire::camera;
using wire::MessageType;

/// The latest image of a camera.
cam::Data newest_image(const world::World& world, world::ModelRow model) {
  return image_of(*world.desc(model).camera, world.cameras.pixels[world.models.part[model]]);
}

class Camera final : public SimulatedDevice {
 public:
  Camera(run::Simulation& simulation, world::ModelRow model)
      : SimulatedDevice(simulation, simulation.world().id(model)) {}

  std::span<const Served> served() const override {
    static constexpr Served kServed[] = {{MessageType::kReq, cam::kReqGetImage}};
    return kServed;
  }

  void request(const device::Message&, device::Replier replier) override {
    ask_world(std::move(replier), [id = model()](const world::World& world) -> std::optional<Bytes> {
      const world::ModelRow model = world.row(id);
      if (!model || world.cameras.measured_tick[world.models.part[model]] == 0) return std::nullopt;
      return wire::encode(newest_image(world, model));
    });
  }

  void emit(const world::World& world, std::vector<device::Publication>& out) override {
    const world::ModelRow row = world.row(model());
    if (!row || world.cameras.measured_tick[world.models.part[row]] != world.tick()) return;
    publish(world, cam::kDataState, newest_image(world, row), out);
  }
};

}  // namespace

std::unique_ptr<SimulatedDevice> make_camera_device(run::Simulation& simulation, world::ModelRow model) {
  return std::make_unique<Camera>(simulation, model);
}

}  // namespace playhouse::drivers
