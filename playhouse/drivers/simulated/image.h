#pragma once

/// Images of cameras as interface camera has them.

#include "playhouse/scene/scene_desc.h"
#include "playhouse/wire/generated/camera.h"
#include "playhouse/world/world.h"

namespace playhouse::drivers {

/// Colours as RGB888, brightness as MONO8, distances as MONO16 [mm] with the low byte first, as they are in
/// the memory of most clients, models as RGB888; or a JPEG file of the first two, if the camera sends that.
wire::camera::Data image_of(const scene::CameraDesc& camera, std::span<const world::Pixel> pixels);

}  // namespace playhouse::drivers
