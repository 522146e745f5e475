#pragma once

/// Which solids of a tree are within others, so that nothing from outside meets them: a scanner built into a
/// robot's body, the transducers around it.
///
/// In: the solids of a tree and the poses that its models have in their parents.
/// Out: Solids::enclosed of each; what is enclosed all over stops no motion, since what holds it does.
/// Cost: a comparison of circles for each pair of solids that one mover carries, and a look at the corners of
///   those whose circles are within each other. Once for a population.

#include "playhouse/stage/bodies.h"

namespace playhouse::stage {

/// Sets `enclosed` of the solids [first, end) of one tree, and what sees those that are enclosed all over.
/// A solid is enclosed by a convex block that moves with it, holds it by more than kMargin and is seen by all
/// who see it.
void find_enclosed(Solids& solids, const world::Models& models, std::size_t first, std::size_t end);

}  // namespace playhouse::stage
