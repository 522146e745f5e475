#include "playhouse/drivers/in_ticks.h"

#include <cstdint>
#include <memory>
#include <utility>

namespace playhouse::drivers {

void run_in_ticks(Site& site, std::span<const device::Address> devices, device::Address robot,
                  AlgorithmThread& thread, std::function<void(const world::World&)> reloaded) {
  constexpr std::uint64_t kDelay = 1;  // ticks from a step to its result
  run::Simulation* const simulation = site.simulation();
  if (simulation == nullptr) return;
  Directory& directory = site.model_devices()->directory();
  for (const device::Address& device : devices) directory.add(directory.model_of(robot), device);
  thread.follow_ticks(simulation->world().tick(), kDelay);
  simulation->follow(
      run::on_event([reloaded = std::move(reloaded)](const world::World& world, const world::Event& event) {
        if (event.kind == world::Event::Kind::kReload) reloaded(world);
      }));
  simulation->follow(run::on_show(
      [&thread](const world::World& world, const world::Pace&) { thread.ticked(world.tick()); }));
}

}  // namespace playhouse::drivers
