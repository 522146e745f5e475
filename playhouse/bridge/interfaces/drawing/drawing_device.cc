#include "playhouse/bridge/interfaces/drawing/drawing_device.h"

#include <memory>
#include <utility>

#include "playhouse/base/in_quotes.h"
#include "playhouse/base/limits.h"
#include "playhouse/base/log.h"

namespace playhouse::drivers {
namespace {

/// Points waiting for the tick thread: some drawings that are cleared and drawn anew meanwhile.
constexpr std::size_t kWaitingPoints = 4 * limits::kDrawnCorners;

/// Clients of the original that set no opacity leave it 0: nobody draws what nobody sees.
scene::Color drawn_color(const wire::Color& color) {
  const auto share = [](std::uint8_t value) { return static_cast<float>(value) / 255; };
  return {share(color.red), share(color.green), share(color.blue),
          color.alpha == 0 ? 1.0f : share(color.alpha)};
}

}  // namespace

device::Taken DrawingDevice::queue(std::size_t points, run::Request work) {
  const std::size_t waiting = waiting_.fetch_add(points);
  const auto done = [self = shared_from_this(), this, points,
                     work = std::move(work)](world::Journal& journal) {
    work(journal);
    waiting_ -= points;
  };
  if (waiting + points <= kWaitingPoints && simulation().requests().post(done, model()))
    return device::Taken::kQueued;
  waiting_ -= points;
  log::warn("a drawing command is dropped: too many before it wait for the run");
  return device::Taken::kNo;
}

void DrawingDevice::draw(world::Journal& journal, const Primitives& shapes, const wire::Color& color) {
  const world::World& world = journal.world();
  const world::ModelRow row = world.row(model());
  if (!row || shapes.points.empty()) return;
  const std::size_t held = world::corners_in(world.models.drawing[row], layer_);
  if (held + shapes.points.size() > limits::kDrawnCorners) return warn_that_it_is_full(world);
  journal.apply(world::changes::Draw{model(), layer_, static_cast<std::uint32_t>(shapes.corners),
                                     drawn_color(color), shapes.points});
}

void DrawingDevice::clear(world::Journal& journal) {
  journal.apply(world::changes::ClearDrawing{model(), layer_});
  has_warned_ = false;
}

void DrawingDevice::warn_that_it_is_full(const world::World& world) {
  if (std::exchange(has_warned_, true)) return;
  log::warn(
      "{} of model {}: the drawing is full, with {} corners of points, lines and triangles at most; "
      "what does not fit is left out until it is cleared",
      layer_ == world::kLayer2d ? "graphics2d" : "graphics3d", in_quotes(world.name(world.row(model()))),
      limits::kDrawnCorners);
}

}  // namespace playhouse::drivers
