/// A blobfinder as interface blobfinder (docs/drivers.md).

#include "playhouse/wire/generated/blobfinder.h"

#include "playhouse/drivers/generated/device_makers.h"
#include "playhouse/scene/forms/colors.h"

namespace playhouse::drivers {
namespace {

namespace bf = wire::blobfinder;

bf::Blob item_of(const world::Blob& blob) {
  bf::Blob item;
  item.id = blob.channel;
  item.color = scene::rgba8(blob.color) >> 8;
  item.area = (blob.right - blob.left + 1) * (blob.bottom - blob.top + 1);
  item.x = (blob.left + blob.right) / 2;
  item.y = (blob.top + blob.bottom) / 2;
  item.left = blob.left;
  item.right = blob.right;
  item.top = blob.top;
  item.bottom = blob.bottom;
  item.range = static_cast<float>(blob.range);
  return item;
}

class Blobfinder final : public SimulatedDevice {
 public:
  Blobfinder(run::Simulation& simulation, world::ModelRow model)
      : SimulatedDevice(simulation, simulation.world().id(model)) {
    const scene::BlobfinderDesc& camera = *simulation.world().desc(model).blobfinder;
    width_ = static_cast<std::uint32_t>(camera.width);
    height_ = static_cast<std::uint32_t>(camera.height);
  }

  std::span<const Served> served() const override { return {}; }
  void request(const device::Message&, device::Replier) override {}

  void emit(const world::World& world, std::vector<device::Publication>& out) override {
    const world::ModelRow row = world.row(model());
    if (!row) return;
    const world::BlobfinderRow camera = world.models.part[row];
    if (world.blobfinders.measured_tick[camera] != world.tick()) return;
    bf::Data data;
    data.width = width_;
    data.height = height_;
    for (const world::Blob& blob : world.blobfinders.blobs[camera]) data.blobs.push_back(item_of(blob));
    publish(world, bf::kDataBlobs, data, out);
  }

 private:
  std::uint32_t width_ = 0, height_ = 0;  // px, of the image
};

}  // namespace

std::unique_ptr<SimulatedDevice> make_blobfinder_device(run::Simulation& simulation, world::ModelRow model) {
  return std::make_unique<Blobfinder>(simulation, model);
}

}  // namespace playhouse::drivers
