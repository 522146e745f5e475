#pragma once

#include "playhouse/base/result.h"
#include "playhouse/scene/plan.h"
#include "playhouse/scene/scene_desc.h"

namespace playhouse::app {

/// Rasterises the walls of a scene: static bodies at `height` above the floor [m]. A pixel is
/// dark if its centre is inside a wall, or if the outline of a wall thinner than a pixel
/// crosses it. Fails if nothing static is at that height, and beyond the size limit of bitmaps.
Result<scene::Plan> plan_of_world(const scene::SceneDesc& scene, double resolution, double height);

}  // namespace playhouse::app
