/// The tick of the 2D engine, phase by phase. Each phase reads what earlier ones froze and writes its own
/// columns.

#include "playhouse/stage/drive.h"
#include "playhouse/stage/stage_engine.h"

namespace playhouse::stage {

void StageEngine::step() {
  ingest();               // what was put elsewhere between ticks      -> solids, index, walls
  decide();               // controllers read the frozen state N       -> commands
  act(world_, workers_);  // drive models                              -> velocities
  if (motion_.move(world_, solids_, index_, walls_, workers_)) index();  // -> poses, odometry, stall; index
  sense();   // of those subscribed and due               -> ranges, fiducials
  freeze();  // tick + 1
}

void StageEngine::ingest() {
  if (world_.teleported.empty()) return;
  bool wall_moved = false;
  for (const world::ModelRow model : world_.teleported)
    wall_moved |= trees_.of_root[world_.models.root[model.index]] == world::ModelRow::kNone;
  world_.teleported.clear();
  place(solids_, world_.models, 0, wall_moved ? solids_.size() : solids_.moving);
  if (wall_moved) walls_ = Walls(solids_);
  index();
}

void StageEngine::decide() {
  for (const std::unique_ptr<world::Decider>& decider : world_.deciders)
    workers_.run(decider->size(), 64,
                 [&](std::size_t begin, std::size_t end) { decider->decide(world_, begin, end); });
}

void StageEngine::index() {
  index_.rebuild(solids_.moving, [&](std::size_t row) {
    const std::uint32_t vertex = solids_.first_vertex[row];
    return DiscIndex::Disc{solids_.center[row],
                           solids_.radius[row],
                           solids_.z_min[row],
                           solids_.z_max[row],
                           static_cast<std::uint32_t>(row),
                           solids_.root[row],
                           vertex,
                           solids_.first_vertex[row + 1] - vertex - 1,
                           static_cast<float>(solids_.ranger_return[row]),
                           solids_.convex[row] != 0};
  });
}

void StageEngine::sense() {
  const Space space{solids_, index_, walls_};
  rays_ += rangers_.sense(world_, space, world_.tick() + 1, workers_);
  rays_ += fiducials_.sense(world_, space, world_.tick() + 1, workers_);
}

void StageEngine::freeze() {
  ++world_.tick_;
}

}  // namespace playhouse::stage
