#include "playhouse/world/changes/journal.h"

#include <algorithm>

namespace playhouse::world {

bool Journal::apply(const Change& change) {
  const bool done = world::apply(world_, change);
  if (done) entries_.push_back(change);
  return done;
}

Result<ModelId> Journal::spawn(std::uint32_t prototype, const geom::Pose& X_WM, std::string name) {
  return apply(changes::Spawn{prototype, X_WM, std::move(name), ids_given_});
}

Result<ModelId> Journal::spawn_copy(ModelId of, const geom::Pose& X_WM, std::string name) {
  return apply(changes::SpawnCopy{of, X_WM, std::move(name), ids_given_});
}

Result<void> Journal::load(std::shared_ptr<const std::vector<std::byte>> state, std::uint64_t seed) {
  ids_given_ = std::max(ids_given_, Population::next_id(world_));
  return apply(changes::Load{seed, std::move(state)});
}

}  // namespace playhouse::world
