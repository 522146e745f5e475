#include "playhouse/behaviour/sense_custom.h"

#include "playhouse/world/custom_hooks.h"

namespace playhouse::behaviour {

void sense_custom(world::World& world, world::CustomRow custom, std::uint64_t tick,
                  const world::Surroundings& around, std::vector<double>& scratch) {
  world::Customs& customs = world.customs;
  const world::ModelRow model = customs.model[custom];
  const world::CustomCode* const code = world::custom_code(world, model);
  if (!code) return;
  std::vector<double>& readings = customs.readings[custom];
  readings.resize(code->sizes.readings);
  scratch.assign(readings.begin(), readings.end());
  world::CustomSensor self{{world::custom_model(world, custom, tick, Purpose::kCustomSense)},
                           customs.state[custom],
                           around,
                           scratch};
  if (!world::call_hook(self, *code, [&] { code->kind->sense(self); })) return;
  if (!world::all_finite(scratch)) {
    world::complain(world, model, *code, "measured a number that is not finite");
    return;
  }
  readings.assign(scratch.begin(), scratch.end());
}

}  // namespace playhouse::behaviour
