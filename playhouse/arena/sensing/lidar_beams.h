#pragma once

/// The rays of a ranger: for a scanner one per beam and ring, for a single-beam transducer
/// a cone of rays (a level fan, one above, one below), of which the nearest echo counts.
/// Frame: M the ranger's model.
///
/// In: the sensors of a ranger, from its description.
/// Out: their rays, in M.
/// Cost: the rays, once for each description.

#include <cstdint>
#include <vector>

#include "playhouse/geom/orientation.h"
#include "playhouse/scene/scene_desc.h"

namespace playhouse::arena {

struct LidarBeams {
  struct BeamRay {
    geom::Vec3 p, d;                       // origin [m], unit vector, in M
    float range_max = 0;                   // m
    std::uint32_t beam = 0;                // of the ranger, over all rings
    bool is_off_axis = false;              // of a cone, other than its axis
    bool begins_fan = false;               // not a neighbour in direction of the ray before
    bool is_turned = false;                // its sensor has angular noise
    std::uint32_t sensor = 0, sample = 0;  // sensor of the ranger; beam over all its rings
  };
  /// The beams of a sensor: ring by ring, from the lowest to the highest.
  struct SensorBeams {
    std::uint32_t first = 0, samples = 0, rings = 1, level = 0;
    double weakest = 0;     // detection threshold of echo power; 0: no intensity model
    double noise_weak = 0;  // m, range noise at the threshold
  };
  std::vector<SensorBeams> sensors;
  std::vector<BeamRay> rays;
  std::vector<double> range_min, range_max;  // m (beams)
  bool is_noisy = false;                     // any sensor has range noise
  bool is_light = false;                     // any sensor has a lidar's error model
  std::size_t beams() const { return range_max.size(); }
};

LidarBeams beams_of(const scene::ModelDesc& ranger);

}  // namespace playhouse::arena
