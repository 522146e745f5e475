#pragma once

/// The rays of a ranger, as its sensors say: one for each beam of a scanner, a cone of them for a transducer
/// of a single beam, which reports the nearest echo. Frame: M the ranger's model.

#include <cstdint>
#include <vector>

#include "playhouse/geom/orientation.h"
#include "playhouse/scene/scene_desc.h"

namespace playhouse::arena {

struct LidarBeams {
  struct Ray {
    geom::Vec3 p, d;           // where it begins [m] and a unit vector, in M
    float range_max = 0;       // m
    std::uint32_t beam = 0;    // of the ranger
    bool is_off_axis = false;  // of a cone, and not its axis
    bool is_turned = false;    // its sensor has angular noise
    std::uint32_t sensor = 0, sample = 0;
  };
  std::vector<Ray> rays;
  std::vector<double> range_min, range_max;  // m (beams)
  bool is_narrow = false;                    // neighbouring rays differ little
  bool is_noisy = false;                     // any sensor has noise along its beams
  std::size_t beams() const { return range_max.size(); }
};

LidarBeams beams_of(const scene::ModelDesc& ranger);

}  // namespace playhouse::arena
