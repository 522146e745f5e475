/// Drawing in a model's frame, as interface graphics3d (docs/drivers.md#drawings).

#include "playhouse/wire/generated/graphics3d.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "playhouse/base/limits.h"
#include "playhouse/bridge/generated/device_makers.h"
#include "playhouse/bridge/interfaces/drawing/drawing_device.h"
#include "playhouse/geom/trig.h"

namespace playhouse::drivers {
namespace {

namespace g3d = wire::graphics3d;
using wire::MessageType;

constexpr std::size_t kFramesMost = 64;  // pushed

/// Where and how a client draws, in the frame M of the model.
struct DrawingFrame {
  geom::Vec3 p_MF;
  geom::Quaternion q_MF;

  geom::Vec3 operator*(const geom::Vec3& p_F) const { return p_MF + q_MF * p_F; }
};

bool is_finite(double a, double b, double c, double d = 0) {
  return std::isfinite(a) && std::isfinite(b) && std::isfinite(c) && std::isfinite(d);
}

class Graphics3d final : public DrawingDevice {
 public:
  Graphics3d(run::Simulation& simulation, world::ModelRow model)
      : DrawingDevice(simulation, model, world::kLayer3d) {}

  std::span<const Served> served() const override {
    static constexpr Served kServed[] = {
        {MessageType::kCmd, g3d::kCmdClear},     {MessageType::kCmd, g3d::kCmdDraw},
        {MessageType::kCmd, g3d::kCmdTranslate}, {MessageType::kCmd, g3d::kCmdRotate},
        {MessageType::kCmd, g3d::kCmdPush},      {MessageType::kCmd, g3d::kCmdPop},
    };
    return kServed;
  }

  device::Taken command(const device::Message& message) override {
    switch (message.subtype) {
      case g3d::kCmdClear:
        return queue(0, [this](world::Journal& journal) {
          clear(journal);
          begin_frames();
        });
      case g3d::kCmdDraw:
        return take<g3d::CmdDraw>(message);
      case g3d::kCmdTranslate:
        return take<g3d::CmdTranslate>(message);
      case g3d::kCmdRotate:
        return take<g3d::CmdRotate>(message);
      case g3d::kCmdPush:
        return queue(0, [this](world::Journal&) { push(); });
      case g3d::kCmdPop:
        return queue(0, [this](world::Journal&) { pop(); });
      default:
        return device::Taken::kNo;
    }
  }

  /// A client is not to draw in the frame that another one has left.
  void opened(world::Journal&) override { begin_frames(); }

 private:
  template <typename Command>
  device::Taken take(const device::Message& message) {
    auto command = wire::decode<Command>(message.body);
    if (!command || !is_possible(*command)) return device::Taken::kNo;
    return queue(points_of(*command), [this, command = std::move(*command)](world::Journal& journal) {
      carry_out(journal, command);
    });
  }

  static bool is_possible(const g3d::CmdDraw& command) {
    return command.points.size() <= limits::kDrawnCorners && primitives_of(command.draw_mode, {}).has_value();
  }
  static bool is_possible(const g3d::CmdTranslate& by) { return is_finite(by.x, by.y, by.z); }
  static bool is_possible(const g3d::CmdRotate& by) {
    return is_finite(by.a, by.x, by.y, by.z) && longest_part(by) > 0;
  }
  static double longest_part(const g3d::CmdRotate& by) {
    return std::max({std::fabs(by.x), std::fabs(by.y), std::fabs(by.z)});
  }
  /// Of an axis whose square, or even length, may be no number.
  static geom::Vec3 direction_of(const g3d::CmdRotate& by) {
    const double longest = longest_part(by);
    const geom::Vec3 way{by.x / longest, by.y / longest, by.z / longest};
    return (1 / std::sqrt(geom::dot(way, way))) * way;
  }
  static std::size_t points_of(const g3d::CmdDraw& command) { return command.points.size(); }
  template <typename Command>
  static std::size_t points_of(const Command&) {
    return 0;
  }

  // Tick thread.

  void carry_out(world::Journal& journal, const g3d::CmdDraw& command) {
    std::vector<geom::Vec3> points;
    for (const wire::Point3d& p : command.points) points.push_back(frame_ * geom::Vec3{p.px, p.py, p.pz});
    draw(journal, *primitives_of(command.draw_mode, points), command.color);
  }
  void carry_out(world::Journal&, const g3d::CmdTranslate& by) {
    frame_.p_MF = frame_ * geom::Vec3{by.x, by.y, by.z};
  }
  void carry_out(world::Journal&, const g3d::CmdRotate& by) {
    const geom::Rotation half = geom::Rotation::of(geom::normalize(by.a) / 2);
    const geom::Vec3 axis = half.s * direction_of(by);
    frame_.q_MF = frame_.q_MF * geom::Quaternion{half.c, axis.x, axis.y, axis.z};
  }
  /// What is pushed too deep has no frame of its own: its pop has no effect either.
  void push() {
    ++depth_;
    if (depth_ <= kFramesMost) pushed_.push_back(frame_);
  }
  void pop() {
    if (depth_ == 0) return;
    if (depth_-- > kFramesMost) return;
    frame_ = pushed_.back();
    pushed_.pop_back();
  }
  void begin_frames() {
    frame_ = {};
    pushed_.clear();
    depth_ = 0;
  }

  DrawingFrame frame_;
  std::vector<DrawingFrame> pushed_;
  std::size_t depth_ = 0;
};

}  // namespace

std::unique_ptr<SimulatedDevice> make_graphics3d_device(run::Simulation& simulation, world::ModelRow model) {
  return std::make_unique<Graphics3d>(simulation, model);
}

}  // namespace playhouse::drivers
