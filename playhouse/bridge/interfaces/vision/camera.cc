/// A camera as interface camera (docs/drivers.md).

#include <string>
#include <utility>

#include "playhouse/bridge/generated/device_makers.h"
#include "playhouse/bridge/interfaces/vision/image.h"
#include "playhouse/bridge/settings/settings.h"

namespace playhouse::drivers {
namespace {

namespace cam = wire::camera;
using wire::MessageType;

/// The latest image of a camera.
cam::Data newest_image(const world::World& world, world::ModelRow model) {
  return image_of(*world.desc(model).camera, world.cameras.pixels[world.models.part[model]]);
}

/// The one input, and a video norm, which means nothing to it.
struct CameraSettings {
  std::string norm;
  std::int32_t source = 0;
};

constexpr std::size_t kNormBytes = 32;  // PAL, NTSC, SECAM and the like

class Camera final : public DeviceWithSettings<CameraSettings> {
 public:
  Camera(run::Simulation& simulation, world::ModelRow model)
      : DeviceWithSettings(simulation, simulation.world().id(model), CameraSettings{}) {}

  std::span<const Served> served() const override {
    static constexpr Served kServed[] = {
        {MessageType::kReq, cam::kReqGetImage},
        {MessageType::kReq, cam::kReqGetSource},
        {MessageType::kReq, cam::kReqSetSource},
    };
    return kServed;
  }

  void request(const device::Message& message, device::Replier replier) override {
    if (message.subtype == cam::kReqGetSource)
      return tell_settings(std::move(replier), [](const CameraSettings& settings) {
        return wire::encode(cam::Source{wire::c_string(settings.norm), settings.source});
      });
    if (message.subtype == cam::kReqSetSource) {
      const auto value = wire::decode<cam::Source>(message.body);
      if (!value) return;
      return change_settings(std::move(replier), [value = *value](CameraSettings& wanted) {
        wanted = {std::string(wire::text(value.norm)), value.source};
        return true;
      });
    }
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

 private:
  std::span<const NamedSetting> named() const override {
    static constexpr NamedSetting kNamed[] = {{"norm", &CameraSettings::norm},
                                              {"source", &CameraSettings::source}};
    return kNamed;
  }
  bool settle(CameraSettings& wanted) const override {
    return wanted.source == 0 && wanted.norm.size() <= kNormBytes;
  }
};

}  // namespace

std::unique_ptr<SimulatedDevice> make_camera_device(run::Simulation& simulation, world::ModelRow model) {
  return std::make_unique<Camera>(simulation, model);
}

}  // namespace playhouse::drivers
