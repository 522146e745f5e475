#include "playhouse/app/pictures/drawn_run.h"

#include <algorithm>
#include <utility>

#include "playhouse/app/world_opener.h"
#include "playhouse/base/fail.h"
#include "playhouse/world/periods.h"

namespace playhouse::app {

Result<void> DrawnRun::begin(std::vector<Error>* others) {
  if (recording_) {
    recording_->rerun->seek(first_tick());
    return {};
  }
  const bool again = simulation_ != nullptr;
  if (again && world().tick() == 0) return {};
  const Warn tell_once = [again](const std::string& line) {
    if (!again) warn(line);
  };
  Result<std::unique_ptr<world::Engine>> engine =
      make_engine(scene_, running_, controllers::Libraries::LibraryUse::kLoad, tell_once, {}, others);
  if (!engine) return engine.error();
  seen_.watch((*engine)->world());
  run::Simulation::SimulationOptions options;
  options.speed = 0;
  simulation_ = std::make_unique<run::Simulation>(std::move(*engine), std::move(options));
  return {};
}

Result<void> DrawnRun::advance(std::uint64_t tick, WorldRenderer& renderer, const Interrupt& interrupt) {
  const std::uint64_t step = world::ticks_of(kSeePeriod, interval());
  const double remembered = renderer.memory() / interval();
  for (std::uint64_t now = world().tick(); now < tick; now = world().tick()) {
    if (interrupt.signal() != 0) return Error{"", "was interrupted"};
    if (const std::optional<std::string> where = differs()) return Error{"", "the run differs " + *where};
    if (static_cast<double>(tick - now) <= remembered)
      if (const Result<void> saw = renderer.see(world()); !saw) return saw;
    this->step(std::min(step, tick - now));
  }
  return {};
}

void DrawnRun::step(std::uint64_t ticks) {
  if (!recording_) {
    simulation_->extend(ticks);
    simulation_->run();
    return;
  }
  for (std::uint64_t k = 0; k < ticks && !recording_->rerun->differs(); ++k) recording_->rerun->step();
}

std::optional<std::uint64_t> DrawnRun::last_tick() const {
  return recording_ ? std::optional(recording_->rerun->last_tick()) : std::nullopt;
}

std::optional<std::string> DrawnRun::differs() const {
  return recording_ ? recording_->rerun->differs() : std::nullopt;
}

}  // namespace playhouse::app
