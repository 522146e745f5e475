/// The phases of the tick that know about bodies in a plane; their order is in behaviour/phased_engine.cc.

#include "playhouse/stage/stage_engine.h"
#include "playhouse/stage/touch.h"

namespace playhouse::stage {

void StageEngine::ingest(std::span<const world::Change> changes) {
  using Kind = world::Change::Kind;
  bool population = false, fixed = false, moved = false;
  for (const world::Change& change : changes) {
    const bool is_fixed = change.kind == Kind::kReload || change.mobility == world::Mobility::kFixed;
    const bool places = change.kind == Kind::kPlace;
    if (change.kind == Kind::kSet) continue;
    population |= !places || moves_within_body(change);
    fixed |= is_fixed;
    moved |= places;
  }
  if (population || fixed) {
    populate(fixed);
  } else if (moved) {
    for (const world::Change& change : changes) replace(change);
    index();
  }
}

/// True if a part of a rigid body was put elsewhere on it: what encloses what may be different.
bool StageEngine::moves_within_body(const world::Change& change) const {
  const world::ModelRow model = world_.row(change.model);
  return change.kind == world::Change::Kind::kPlace && model &&
         world_.models.parent[model.index] != world::ModelRow::kNone &&
         !world::moves(world_.models.kind[model.index]);
}

/// Solids of a tree that was put elsewhere.
void StageEngine::replace(const world::Change& change) {
  const world::ModelRow model = world_.row(change.model);
  if (change.kind != world::Change::Kind::kPlace || !model) return;
  const std::uint32_t tree = trees_.of_root(world_.models.root[model.index]);
  turn(solids_, world_.models, trees_.models_of(tree));
  place(solids_, world_.models, trees_.first_solid[tree], trees_.first_solid[tree + 1]);
  motion_.replaced(tree, solids_, world_.models);
}

void StageEngine::move() {
  if (motion_.move(world_, solids_, index_, walls_, workers_)) index();
}

void StageEngine::index() {
  index_.rebuild(
      solids_.moving(), [&](std::size_t i) { return disc_of(solids_, solids_.fixed + i); }, workers_);
}

void StageEngine::sense(std::uint64_t tick) {
  rays_ += senses_.sense(world_, space(), tick, workers_);
}

void StageEngine::touching(world::ModelRow model, std::span<const std::uint8_t> wanted,
                           std::vector<std::uint32_t>& out) const {
  stage::touching(space(), trees_, world_.models, model, wanted, out);
}

}  // namespace playhouse::stage
