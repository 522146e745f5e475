#include "playhouse/scene/forms/camera.h"

#include <fmt/format.h>

#include "playhouse/base/limits.h"
#include "playhouse/scene/properties.h"

namespace playhouse::scene {
namespace {

double tangent_of_half(double angle) {
  const geom::SinCos half = geom::sincos(0.5 * angle);
  return half.sin / half.cos;
}

}  // namespace

HalfImage half_image(const CameraDesc& camera, double zoom) {
  const double width = tangent_of_half(zoom);
  return {width, width * tangent_of_half(camera.fov_vertical) / tangent_of_half(camera.fov_horizontal)};
}

double vertical_fov(const CameraDesc& camera, double zoom) {
  if (zoom == camera.fov_horizontal) return camera.fov_vertical;
  return 2 * geom::atan2(half_image(camera, zoom).height, 1);
}

std::size_t pixels_of(const CameraDesc& camera) {
  return static_cast<std::size_t>(camera.width) * static_cast<std::size_t>(camera.height);
}

std::size_t kept_pixels_of(const CameraDesc& camera) {
  return (camera.baseline > 0 ? 3 : 1) * pixels_of(camera);
}

double focal_length(const CameraDesc& camera, double zoom) {
  return 0.5 * static_cast<double>(camera.width) / half_image(camera, zoom).width;
}

void check_camera(const Properties& properties, const CameraDesc& camera) {
  if (camera.baseline > 0 && pixels_of(camera) > limits::kStereoPixels)
    properties.state().fail(
        properties.where("resolution"),
        fmt::format("\"resolution\" of a camera with a baseline needs {} pixels at most; this one has {}",
                    limits::kStereoPixels, pixels_of(camera)));
  const bool is_seen = camera.image == ImageKind::kColor || camera.image == ImageKind::kGray;
  if (is_seen || camera.compression != ImageCompression::kJpeg) return;
  const std::string what = camera.image == ImageKind::kDepth ? "distances" : "models";
  properties.state().warnings.add(config::Warning::kValue, properties.where("compression"),
                                  "images of " + what + " are sent raw; \"compression\" has no effect");
}

}  // namespace playhouse::scene
