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
  take_events();                // spawns, removals, attachments, teleports    -> the engine's tables
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

void PhasedEngine::take_events() {
  // All readers have processed events from before the previous tick.
  world_.events.drop_before(next_event_);
  next_event_ = world_.events.end();
  ingest_events();
}

void PhasedEngine::ingest_events() {
  const std::span<const world::Event> events = world_.events.since(next_ingested_);
  if (events.empty()) return;
  next_ingested_ = world_.events.end();
  ingest(events);
}

/// Models removed since the last tick may still be in the engine's tables.
world::PhysicsShapes PhasedEngine::physics_shapes() {
  ingest_events();
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
