#pragma once

#include "playhouse/base/result.h"
#include "playhouse/scene/plan.h"
#include "playhouse/scene/scene_desc.h"

namespace playhouse::app {

/// The walls of a scene as an image: what stands still and is at `height` above the floor [m]. A pixel is
/// dark whose middle is within a wall, or that the outline of a wall goes through which is thinner than a
/// pixel. Fails where nothing stands still at that height, and on more pixels than a bitmap may have.
Result<scene::Plan> plan_of_world(const scene::SceneDesc& scene, double resolution, double height);

}  // namespace playhouse::app
