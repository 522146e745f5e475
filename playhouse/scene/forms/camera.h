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
/// Number of pixels that a run may keep of it: of a stereo camera also the other image, and the depths.
std::size_t kept_pixels_of(const CameraDesc& camera);

/// Focal length, for the horizontal field of view `zoom` [rad]. [px]
double focal_length(const CameraDesc& camera, double zoom);

/// Warns of depth or segmentation images with JPEG compression; an error if pairs of images are too large.
void check_camera(const Properties& properties, const CameraDesc& camera);

}  // namespace playhouse::scene
