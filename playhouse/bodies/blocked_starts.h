#pragma once

/// Robots that overlap something where they are, as at the start of a run: they stall, the commonest error of
/// a new world file.
///
/// In: a world.
/// Out: lines for the log, or a name.

#include <string>
#include <vector>

#include "playhouse/world/world.h"

namespace playhouse::bodies {

/// A line "file:line: ..." for each overlap of the body of a robot with an obstacle of another tree, at the
/// heights that both have; limits::kWarningsOfAKind at most, then one for the others. None of worlds with
/// more than 10,000 robots. Cost: the robots, times what shares their rows of the plane.
std::vector<std::string> blocked_starts(const world::World& world);

/// The name in quotes of a model of another tree that the tree of `model` overlaps, at the heights that both
/// have; empty if there is none, and in worlds with more than 2,000 models. Cost: the models.
std::string overlapped_by(const world::World& world, world::ModelRow model);

}  // namespace playhouse::bodies
