#pragma once

/// Pinhole camera geometry.

#include "playhouse/scene/scene_desc.h"

namespace playhouse::scene {

class Properties;

/// Half extents of the image plane at distance 1, for the horizontal field
/// of view `zoom` [rad]; the aspect ratio of pixels is that of the file.
struct HalfImage {
  double width = 0, height = 0;
};
HalfImage half_image(const CameraDesc& camera, double zoom);

/// The vertical field of view for a horizontal one. [rad]
double vertical_fov(const CameraDesc& camera, double zoom);

/// Number of pixels of its image.
std::size_t pixels_of(const CameraDesc& camera);

/// Warns of depth or segmentation images with JPEG compression.
void check_camera(const Properties& properties, const CameraDesc& camera);

}  // namespace playhouse::scene
