#include "playhouse/behaviour/due_list.h"

#include "playhouse/world/periods.h"

namespace playhouse::behaviour {

void DueList::populate(const world::World& world, std::span<const world::ModelRow> models) {
  period_.clear();
  for (const scene::ModelDesc& desc : world.scene().models)
    period_.push_back(world::ticks_of(desc.update_interval, world.scene().interval));
  due_.reserve(models.size());
}

std::span<const world::KindRow> DueList::take(const world::World& world, SensorTable table,
                                              std::uint64_t tick) {
  due_.clear();
  for (std::uint32_t row = 0; row < table.model.size(); ++row) {
    const world::ModelRow model = table.model[row];
    if (world.models.subscribers[model] == 0) continue;
    if (tick - table.measured_tick[row] < period_[world.models.desc[model]]) continue;
    table.measured_tick[row] = tick;
    due_.push_back({row});
  }
  return due_;
}

}  // namespace playhouse::behaviour
