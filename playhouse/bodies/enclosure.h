#pragma once

/// Which solids of a tree are enclosed by others, so that rays from outside cannot
/// hit them: a scanner built into a robot's body, the transducers around it.
///
/// In: the solids of a tree and the poses of its models in their parents.
/// Out: Solids::enclosed; solids enclosed all over block no motion, since their enclosure does.
/// Cost: a test of bounding circles for each pair of solids on one mover, and of corners for the pairs
///   with nested circles. Once for a population.

#include "playhouse/bodies/bodies.h"

namespace playhouse::bodies {

/// Sets `enclosed` of `rows`, the solids of one tree, and `seen_by` of those
/// enclosed all over. A solid is enclosed by a convex block that is rigidly attached to
/// it, holds it with a margin of kMargin, and is visible to at least as many.
void find_enclosed(Solids& solids, const world::Models& models, SolidRows rows);

}  // namespace playhouse::bodies
