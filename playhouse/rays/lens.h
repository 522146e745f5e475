#pragma once

/// Lens: the view direction of each pixel of a camera. All bodies are upright
/// prisms, so what a pixel sees lies in the vertical plane through the lens and
/// the pixel; pixels that share such a plane, a slice, are traced together.
///
/// Source: pinhole camera with its image plane at distance 1, pitched up by the
/// tilt. Columns of a level camera are slices, exactly. Columns of a tilted
/// camera are not vertical planes: its pixels are assigned to the nearest of
/// slices half a mean column apart, an error of at most a quarter of a pixel.
///
/// In: the description of a camera, its tilt and its zoom.
/// Out: the slices, and the pixels of each.
/// Cost: the pixels; with a tilt also an arc tangent for each.

#include <cstddef>
#include <cstdint>
#include <vector>

#include "playhouse/geom/pose.h"
#include "playhouse/scene/forms/camera.h"

namespace playhouse::rays {

struct Lens {
  std::vector<geom::Rotation> ahead;  // directions from the camera's heading                  (slices)
  std::vector<double> reach;          // m, farthest drawn distance on the floor plane              (slices)
  std::vector<std::uint32_t> first;   // pixels first[s] .. first[s + 1] - 1 are of slice s    (slices + 1)
  std::vector<std::uint32_t> place;   // index in the image, row-major from the top left           (pixels)
  /// Horizontal distance per metre of rise, never 0; padded by kPad.                       (pixels)
  std::vector<double> run;
  std::vector<double> least;  // m on the floor to the near plane; padded too        (pixels)
  static constexpr std::size_t kPad = 4;
  std::vector<double> depth;  // m of depth per metre on the floor                (pixels)
};

/// The lens of a camera with this pitch up and this horizontal field of view. [rad]
Lens make_lens(const scene::CameraDesc& camera, double tilt, double zoom);

}  // namespace playhouse::rays
