#include "playhouse/web_server/watched_sensors.h"

#include <utility>

#include "playhouse/replicate/snapshot_feed.h"

namespace playhouse::web_server {
namespace {

void open_sensors(world::Journal& journal, const world::Control& control, world::ModelId robot,
                  std::vector<world::Use>& uses) {
  const world::World& world = journal.world();
  const world::ModelRow top = world.row(robot);
  if (!top) return;
  for (const world::ModelRow row : world.models.rows()) {
    if (world.models.root[row] != top || !replicate::may_be_watched(world.models.kind[row])) continue;
    uses.emplace_back().watch(journal, control, world.id(row));
  }
}

}  // namespace

void WatchedSensors::select(std::set<world::ModelId> robots) {
  selected_ = std::move(robots);
  reconcile();
}

/// Retries if the queue is full.
void WatchedSensors::reconcile() {
  bool done = true;
  for (const world::ModelId robot : selected_)
    if (!begun_.contains(robot) && !begin(robot)) done = false;
  std::erase_if(begun_, [&](const auto& held) {
    if (selected_.contains(held.first)) return false;
    const bool ended = end(held.second);
    done = done && ended;
    return ended;
  });
  if (done) return;
  retry_ = network_.after(replicate::kFramePeriod, [this] { reconcile(); });
}

bool WatchedSensors::begin(world::ModelId robot) {
  auto uses = std::make_shared<Measuring>();  // owned by the tick thread once posted
  const auto open = [robot, uses, &control = control_](world::Journal& journal) {
    open_sensors(journal, control, robot, *uses);
  };
  if (!control_.post(open)) return false;
  begun_[robot] = std::move(uses);
  return true;
}

bool WatchedSensors::end(const std::shared_ptr<Measuring>& uses) {
  return control_.post([uses, &control = control_](world::Journal& journal) {
    for (world::Use& use : *uses) use.end(journal, control);
  });
}

}  // namespace playhouse::web_server
