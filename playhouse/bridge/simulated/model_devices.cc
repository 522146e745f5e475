#include "playhouse/bridge/simulated/model_devices.h"

#include <utility>

namespace playhouse::drivers {

ModelDevices::ModelDevices(run::Simulation& simulation, device::Publisher& publisher)
    : simulation_(simulation), publisher_(publisher) {
  simulation.follow(*this);
}

/// Data of before do not count in another state.
void ModelDevices::happened(const world::World&, const world::Event& event) {
  if (event.kind == world::Event::EventKind::kReload) publisher_.forget();
}

/// A few messages are encoded at once; many are left to the publisher thread.
void ModelDevices::ticked(const world::World& world) {
  const std::size_t ranges = sources_.ranges();
  is_due_ = ranges > 1;
  if (is_due_) return;
  if (ranges == 1) sources_.emit_range(world, 0);
  publish();
}

std::optional<run::Work> ModelDevices::work(const world::World&, const world::Pace&) {
  if (!std::exchange(is_due_, false)) return {};
  return run::Work{sources_.ranges(),
                   [this](std::size_t range) { sources_.emit_range(simulation_.world(), range); },
                   [this] { publish(); }};
}

void ModelDevices::publish() {
  batch_.clear();
  sources_.join(batch_);
  if (!batch_.empty()) publisher_.publish(std::exchange(batch_, {}));
}

}  // namespace playhouse::drivers
