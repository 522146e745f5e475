/// The tick of the 2D engine, phase by phase. Each phase reads what earlier ones froze and writes its own
/// columns.

#include "playhouse/stage/drive.h"
#include "playhouse/stage/stage_engine.h"

namespace playhouse::stage {

void StageEngine::step() {
  ingest();               // who came, went, was put elsewhere          -> solids, index, walls
  decide();               // controllers read the frozen state N       -> commands
  act(world_, workers_);  // drive models                              -> velocities
  if (motion_.move(world_, solids_, index_, walls_, workers_)) index();  // -> poses, odometry, stall; index
  sense();   // of those subscribed and due               -> ranges, fiducials
  freeze();  // tick + 1
}

void StageEngine::ingest() {
  // Everyone has seen what was there before the last tick.
  world_.changes.drop_before(next_change_);
  const std::span<const world::Change> changes = world_.changes.since(next_change_);
  if (changes.empty()) return;
  next_change_ = world_.changes.end();

  using Kind = world::Change::Kind;
  bool population = false, fixed = false, moved = false;
  for (const world::Change& change : changes) {
    const bool is_fixed = change.kind == Kind::kReload || change.mobility == world::Mobility::kFixed;
    const bool places = change.kind == Kind::kPlace;
    if (change.kind == Kind::kSet) continue;
    population |= !places;
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

/// Solids of a tree that was put elsewhere.
void StageEngine::replace(const world::Change& change) {
  const world::ModelRow model = world_.row(change.model);
  if (change.kind != world::Change::Kind::kPlace || !model) return;
  const std::uint32_t tree = trees_.of_root(world_.models.root[model.index]);
  place(solids_, world_.models, trees_.first_solid[tree], trees_.first_solid[tree + 1]);
}

void StageEngine::decide() {
  for (const std::unique_ptr<world::Decider>& decider : world_.deciders) decider->follow(world_);
  for (const std::unique_ptr<world::Decider>& decider : world_.deciders)
    workers_.run(decider->size(), 64,
                 [&](std::size_t begin, std::size_t end) { decider->decide(world_, begin, end); });
}

void StageEngine::index() {
  index_.rebuild(
      solids_.moving(), [&](std::size_t i) { return disc_of(solids_, solids_.fixed + i); }, workers_);
}

void StageEngine::sense() {
  rays_ += senses_.sense(world_, {solids_, index_, walls_}, world_.tick() + 1, workers_);
}

void StageEngine::freeze() {
  ++world_.tick_;
}

}  // namespace playhouse::stage
