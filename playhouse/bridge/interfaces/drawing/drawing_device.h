#pragma once

/// DrawingDevice: what clients draw by one interface in the frame of a model (docs/drivers.md#drawings). Commands
/// add to the drawing, so each is carried out, in order, on the tick thread.

#include <atomic>
#include <cstddef>
#include <cstdint>

#include "playhouse/bridge/interfaces/drawing/primitives.h"
#include "playhouse/bridge/simulated/simulated_device.h"
#include "playhouse/wire/generated/common.h"
#include "playhouse/world/drawing.h"

namespace playhouse::drivers {

class DrawingDevice : public SimulatedDevice {
 public:
  /// Draws in this layer (world/drawing.h).
  DrawingDevice(run::Simulation& simulation, world::ModelRow model, std::uint32_t layer)
      : SimulatedDevice(simulation, simulation.world().id(model)), layer_(layer) {}

  void request(const device::Message&, device::Replier) final {}
  bool commands_act() const final { return false; }

 protected:
  /// Has `work` done on the tick thread, with so many points in its memory; kNo, without effect, if too many
  /// points or requests are waiting.
  device::Taken queue(std::size_t points, run::Request work);

  // Tick thread.
  void draw(world::Journal& journal, const Primitives& shapes, const wire::Color& color);
  void clear(world::Journal& journal);

 private:
  void warn_that_it_is_full(const world::World& world);

  const std::uint32_t layer_;
  std::atomic<std::size_t> waiting_ = 0;  // points of works that are not done
  bool has_warned_ = false;               // since the last clear; tick thread
};

}  // namespace playhouse::drivers
