/// A camera with two lenses as interface stereo (docs/drivers.md).
///
/// Source: lenses side by side, with parallel axes and the focal length f, see a point of depth z in columns that
///   are f B / z apart, B being the distance between them (Hartley, Zisserman, "Multiple View Geometry in Computer
///   Vision", 2004, 9.1).

#include "playhouse/wire/generated/stereo.h"

#include <algorithm>
#include <cmath>

#include "playhouse/bridge/generated/device_makers.h"
#include "playhouse/bridge/interfaces/vision/image.h"
#include "playhouse/scene/forms/camera.h"

namespace playhouse::drivers {
namespace {

namespace cam = wire::camera;
using Point = wire::stereo::Pointcloud3dStereoElement;
using scene::ImageKind;

constexpr std::uint32_t kStepsPerPixel = 16;
constexpr double kMostSteps = 65535;  // what two bytes hold

/// Sixteenths of a pixel, low byte first; 0 where nothing is in range.
cam::Data disparity_of(const scene::CameraDesc& camera, double zoom, std::span<const float> depths) {
  cam::Data data;
  data.width = static_cast<std::uint32_t>(camera.width);
  data.height = static_cast<std::uint32_t>(camera.height);
  data.bpp = 16;
  data.format = cam::kFormatMono16;
  data.fdiv = kStepsPerPixel;
  data.compression = cam::kCompressRaw;
  data.image.reserve(2 * depths.size());
  const double scale = kStepsPerPixel * scene::focal_length(camera, zoom) * camera.baseline;
  for (const float depth : depths) {
    const double steps = depth > 0 ? std::min(scale / static_cast<double>(depth), kMostSteps) : 0;
    const auto value = static_cast<std::uint32_t>(std::lround(steps));
    data.image.push_back(static_cast<std::uint8_t>(value));
    data.image.push_back(static_cast<std::uint8_t>(value >> 8));
  }
  return data;
}

/// What a pixel shows; white if that is a distance.
void paint(Point& point, ImageKind image, std::uint32_t sample) {
  const auto channel = [=](int shift) { return static_cast<std::uint8_t>(sample >> shift); };
  switch (image) {
    case ImageKind::kColor:
    case ImageKind::kSegmentation:
      point.red = channel(16), point.green = channel(8), point.blue = channel(0);
      return;
    case ImageKind::kGray:
      point.red = point.green = point.blue = channel(0);
      return;
    case ImageKind::kDepth:
      point.red = point.green = point.blue = 255;
      return;
  }
}

/// In the frame of the left lens: x along its axis, y to the left, z up.
std::vector<Point> points_of(const scene::CameraDesc& camera, double zoom, std::span<const float> depths,
                             std::span<const world::Pixel> pixels) {
  const auto width = static_cast<std::size_t>(camera.width);
  const scene::HalfImage half = scene::half_image(camera, zoom);
  std::vector<Point> points;
  for (std::size_t i = 0; i < depths.size(); ++i) {
    if (depths[i] <= 0) continue;
    const auto depth = static_cast<double>(depths[i]);
    const double column = static_cast<double>(i % width) + 0.5, row = static_cast<double>(i / width) + 0.5;
    const double to_the_left = half.width * (1 - 2 * column / static_cast<double>(camera.width));
    const double up = half.height * (1 - 2 * row / static_cast<double>(camera.height));
    Point point;
    point.px = depths[i];
    point.py = static_cast<float>(depth * to_the_left);
    point.pz = static_cast<float>(depth * up);
    paint(point, camera.image, pixels[i].sample);
    points.push_back(point);
  }
  return points;
}

class Stereo final : public SimulatedDevice {
 public:
  Stereo(run::Simulation& simulation, world::ModelRow model)
      : SimulatedDevice(simulation, simulation.world().id(model)) {}

  std::span<const Served> served() const override { return {}; }
  void request(const device::Message&, device::Replier) override {}

  void emit(const world::World& world, std::vector<device::Publication>& out) override {
    const world::ModelRow row = world.row(model());
    if (!row) return;
    const world::Cameras& cameras = world.cameras;
    const world::CameraRow camera = world.models.part[row];
    const scene::CameraDesc& desc = *world.desc(row).camera;
    const bool is_pair = cameras.depths[camera].size() == scene::pixels_of(desc);
    if (cameras.measured_tick[camera] != world.tick() || !is_pair) return;
    const double zoom = cameras.zoom[camera];
    wire::stereo::Data data;
    data.left_channel = image_of(desc, cameras.pixels[camera]);
    data.right_channel = image_of(desc, cameras.right_pixels[camera]);
    data.disparity = disparity_of(desc, zoom, cameras.depths[camera]);
    data.points = points_of(desc, zoom, cameras.depths[camera], cameras.pixels[camera]);
    publish(world, wire::stereo::kDataState, data, out);
  }

  void opened(world::Journal& journal) override { journal.apply(world::changes::OpenStereo{model(), true}); }
  void closed(world::Journal& journal) override { journal.apply(world::changes::OpenStereo{model(), false}); }
};

}  // namespace

std::unique_ptr<SimulatedDevice> make_stereo_device(run::Simulation& simulation, world::ModelRow model) {
  return std::make_unique<Stereo>(simulation, model);
}

}  // namespace playhouse::drivers
