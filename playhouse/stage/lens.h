#pragma once

/// Lens: which way each pixel of a camera looks. The world is made of upright prisms, so all that a pixel may
/// see is in the vertical plane through the lens and the pixel; pixels that share such a plane, a slice, are
/// worked on together.
///
/// Source: a pinhole's image on a plane at distance 1 along the way it looks, turned up by the tilt. A level
///   camera's columns are slices, exactly. Those of a tilted one are not in a vertical plane: its pixels go
///   to the nearest of slices that are half a mean column apart, which is off by a quarter of a pixel at
///   most.

#include <cstddef>
#include <cstdint>
#include <vector>

#include "playhouse/geom/pose.h"
#include "playhouse/scene/camera.h"

namespace playhouse::stage {

struct Lens {
  std::vector<geom::Rotation> ahead;  // directions from the camera's heading                  (slices)
  std::vector<double> reach;          // m, on the floor, of what may be shown                 (slices)
  std::vector<std::uint32_t> first;   // pixels first[s] .. first[s + 1] - 1 are of slice s    (slices + 1)
  std::vector<std::uint32_t> place;   // in the image, row by row from the top left corner     (pixels)
  /// m on the floor for each that it rises, not 0; kSpare more to read.                       (pixels)
  std::vector<double> run;
  std::vector<double> least;  // m on the floor to the nearest that is shown; as many   (pixels)
  static constexpr std::size_t kSpare = 4;
  std::vector<double> depth;  // m along the way it looks for each on the floor        (pixels)
};

/// The lens of a camera that is tilted up by `tilt` and has this horizontal field of view. [rad]
Lens make_lens(const scene::CameraDesc& camera, double tilt, double zoom);

}  // namespace playhouse::stage
