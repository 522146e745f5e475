#pragma once

/// The view of a camera: a pinhole's, on a plane ahead of it.

#include "playhouse/scene/scene_desc.h"

namespace playhouse::scene {

class Properties;

/// Half the width and half the height of the image at a distance of 1 along the way it looks, where the
/// horizontal field of view is `zoom` [rad]: pixels keep the proportions that they have by the file.
struct HalfImage {
  double width = 0, height = 0;
};
HalfImage half_image(const CameraDesc& camera, double zoom);

/// The vertical field of view that goes with a horizontal one. [rad]
double vertical_fov(const CameraDesc& camera, double zoom);

/// How many pixels its image has.
std::size_t pixels_of(const CameraDesc& camera);

/// Warns of images of distances or of models that a file wants as JPEG.
void check_camera(const Properties& properties, const CameraDesc& camera);

}  // namespace playhouse::scene
