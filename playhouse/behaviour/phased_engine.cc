#include "playhouse/behaviour/phased_engine.h"

#include "playhouse/behaviour/generated/acts.h"

namespace playhouse::behaviour {

PhasedEngine::PhasedEngine(const scene::SceneDesc& scene, std::uint64_t seed, unsigned workers)
    : world_(scene, seed), workers_(workers) {
  add_acts(acts_);
}

void PhasedEngine::step() {
  decide();                     // controllers read the frozen state N        -> commands
  deliver();                    // their effects on models, sequentially       -> flags, texts
  acts_.act(world_, workers_);  // drive models and other actuators            -> velocities, changes
  take_changes();               // spawns, removals, attachments, teleports    -> the engine's tables
  move();                       // trees of models                            -> poses, odometry, stall
  sense(world_.tick() + 1);     // sensors that are subscribed and due         -> ranges, fiducials
  filter();                     // controllers that filter measurements        -> measurements
  flow();                       // batteries to consumers and by contact       -> batteries
  freeze();                     // tick + 1
}

void PhasedEngine::decide() {
  for (const std::unique_ptr<world::Decider>& decider : world_.deciders) decider->follow(world_);
  for (const std::unique_ptr<world::Decider>& decider : world_.deciders)
    workers_.run(decider->size(), 64,
                 [&](std::size_t begin, std::size_t end) { decider->decide(world_, begin, end); });
}

void PhasedEngine::deliver() {
  for (const std::unique_ptr<world::Decider>& decider : world_.deciders) decider->deliver(world_);
}

void PhasedEngine::take_changes() {
  // All readers have processed changes from before the previous tick.
  world_.changes.drop_before(next_change_);
  next_change_ = world_.changes.end();
  ingest_changes();
}

void PhasedEngine::ingest_changes() {
  const std::span<const world::Change> changes = world_.changes.since(next_ingested_);
  if (changes.empty()) return;
  next_ingested_ = world_.changes.end();
  ingest(changes);
}

/// Models removed since the last tick may still be in the engine's tables.
world::PhysicsShapes PhasedEngine::physics_shapes() {
  ingest_changes();
  return shapes();
}

void PhasedEngine::filter() {
  for (const std::unique_ptr<world::Decider>& decider : world_.deciders) {
    if (!decider->filters()) continue;
    workers_.run(decider->size(), 64,
                 [&](std::size_t begin, std::size_t end) { decider->filter(world_, begin, end); });
  }
}

void PhasedEngine::flow() {
  energy_.drain(world_, workers_);
  for (const Energy::Giver& giver : energy_.givers()) {
    if (!Energy::gives(world_, giver)) continue;
    touching_.clear();
    touching(giver.model, energy_.takers(), touching_);
    Energy::charge(world_, giver, touching_);
  }
}

void PhasedEngine::freeze() {
  ++world_.tick_;
}

}  // namespace playhouse::behaviour
