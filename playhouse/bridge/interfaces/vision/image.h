#pragma once

/// Camera images in the format of interface camera.

#include "playhouse/scene/scene_desc.h"
#include "playhouse/wire/generated/camera.h"
#include "playhouse/world/world.h"

namespace playhouse::drivers {

/// Colour as RGB888, brightness as MONO8, depth as MONO16 [mm, little-endian, as in most
/// clients' memory], segmentation as RGB888; the first two as JPEG if the camera is set to that.
wire::camera::Data image_of(const scene::CameraDesc& camera, std::span<const world::Pixel> pixels);

}  // namespace playhouse::drivers
