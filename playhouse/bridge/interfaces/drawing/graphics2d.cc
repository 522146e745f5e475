/// Drawing on the floor of a model's frame, as interface graphics2d (docs/drivers.md#drawings).

#include "playhouse/wire/generated/graphics2d.h"

#include <span>
#include <utility>
#include <vector>

#include "playhouse/base/limits.h"
#include "playhouse/bridge/generated/device_makers.h"
#include "playhouse/bridge/interfaces/drawing/drawing_device.h"
#include "playhouse/wire/generated/graphics3d.h"

namespace playhouse::drivers {
namespace {

namespace g2d = wire::graphics2d;
namespace g3d = wire::graphics3d;
using wire::MessageType;

constexpr double kHeightOf2d = 0.02;  // m: above trails and marks of the floor

/// Shapes and their color.
struct Painted {
  Primitives shapes;
  wire::Color color;
};

std::vector<geom::Vec3> on_the_floor(std::span<const wire::Point2d> points) {
  std::vector<geom::Vec3> out;
  for (const wire::Point2d& p : points) out.push_back({p.px, p.py, kHeightOf2d});
  return out;
}

std::vector<Painted> painted(std::int32_t mode, std::span<const wire::Point2d> points,
                             const wire::Color& color) {
  return {{*primitives_of(static_cast<std::uint32_t>(mode), on_the_floor(points)), color}};
}

/// The inside, then the outline on top.
std::vector<Painted> painted(const g2d::CmdPolygon& polygon) {
  std::vector<Painted> out;
  if (polygon.filled != 0) {
    std::vector<geom::Vec2> outline;
    for (const wire::Point2d& p : polygon.points) outline.push_back({p.px, p.py});
    out.push_back({filled(outline, kHeightOf2d), polygon.fill_color});
  }
  out.push_back({*primitives_of(g3d::kDrawLineLoop, on_the_floor(polygon.points)), polygon.color});
  return out;
}

class Graphics2d final : public DrawingDevice {
 public:
  Graphics2d(run::Simulation& simulation, world::ModelRow model)
      : DrawingDevice(simulation, model, world::kLayer2d) {}

  std::span<const Served> served() const override {
    static constexpr Served kServed[] = {
        {MessageType::kCmd, g2d::kCmdClear},     {MessageType::kCmd, g2d::kCmdPoints},
        {MessageType::kCmd, g2d::kCmdPolyline},  {MessageType::kCmd, g2d::kCmdPolygon},
        {MessageType::kCmd, g2d::kCmdMultiline},
    };
    return kServed;
  }

  device::Taken command(const device::Message& message) override {
    switch (message.subtype) {
      case g2d::kCmdClear:
        return queue(0, [this](world::Journal& journal) { clear(journal); });
      case g2d::kCmdPoints:
        return paint<g2d::CmdPoints>(message, [](const auto& command) {
          return painted(g3d::kDrawPoints, command.points, command.color);
        });
      case g2d::kCmdPolyline:
        return paint<g2d::CmdPolyline>(message, [](const auto& command) {
          return painted(g3d::kDrawLineStrip, command.points, command.color);
        });
      case g2d::kCmdMultiline:
        return paint<g2d::CmdMultiline>(message, [](const auto& command) {
          return painted(g3d::kDrawLines, command.points, command.color);
        });
      case g2d::kCmdPolygon:
        return paint<g2d::CmdPolygon>(message, [](const auto& command) { return painted(command); });
      default:
        return device::Taken::kNo;
    }
  }

 private:
  template <typename Command, typename Meaning>
  device::Taken paint(const device::Message& message, const Meaning& meaning) {
    const auto command = wire::decode<Command>(message.body);
    if (!command || command->points.size() > limits::kDrawnCorners) return device::Taken::kNo;
    std::vector<Painted> all = meaning(*command);
    std::size_t points = 0;
    for (const Painted& each : all) points += each.shapes.points.size();
    return queue(points, [this, all = std::move(all)](world::Journal& journal) {
      for (const Painted& each : all) draw(journal, each.shapes, each.color);
    });
  }
};

}  // namespace

std::unique_ptr<SimulatedDevice> make_graphics2d_device(run::Simulation& simulation, world::ModelRow model) {
  return std::make_unique<Graphics2d>(simulation, model);
}

}  // namespace playhouse::drivers
