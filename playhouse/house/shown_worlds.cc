#include "playhouse/house/shown_worlds.h"

#include <algorithm>

namespace playhouse::house {
namespace {

constexpr std::size_t kKept = 4000;  // snapshots; two minutes of frames

}  // namespace

ShownWorlds::ShownWorlds(const world::World& world) : prototypes_(world.scene()) {
  show(world, {});
}

void ShownWorlds::show(const world::World& world, const world::Pace& pace) {
  std::shared_ptr<const replicate::Layout> layout = snapshots_.empty() ? nullptr : snapshots_.back().layout;
  if (!layout || layout->population != world.population())
    layout =
        std::make_shared<const replicate::Layout>(world, prototypes_, replicate::DeviceNames(), layout.get());
  if (snapshots_.size() >= kKept) snapshots_.pop_front();
  replicate::capture(world, pace, std::move(layout), {}, snapshots_.emplace_back());
}

std::shared_ptr<const replicate::Layout> ShownWorlds::population(
    const std::function<bool(const replicate::Layout&)>& fits) const {
  const replicate::Layout* last = nullptr;
  for (auto snapshot = snapshots_.rbegin(); snapshot != snapshots_.rend(); ++snapshot) {
    if (snapshot->layout.get() != last && fits(*snapshot->layout)) return snapshot->layout;
    last = snapshot->layout.get();
  }
  return nullptr;
}

bool ShownWorlds::has(std::uint64_t tick, const replicate::Layout& layout,
                      std::span<const replicate::ModelState> models) const {
  return std::any_of(snapshots_.rbegin(), snapshots_.rend(), [&](const replicate::Snapshot& snapshot) {
    return snapshot.tick == tick && snapshot.layout->id == layout.id &&
           std::ranges::equal(snapshot.models, models);
  });
}

}  // namespace playhouse::house
