#pragma once

/// The rays of a ranger, as its sensors say: one for each beam of each ring of a scanner, a cone of them for
/// a transducer of a single beam, which reports the nearest echo. Frame: M the ranger's model.

#include <cstdint>
#include <vector>

#include "playhouse/geom/orientation.h"
#include "playhouse/scene/scene_desc.h"

namespace playhouse::arena {

struct LidarBeams {
  struct Ray {
    geom::Vec3 p, d;                       // where it begins [m] and a unit vector, in M
    float range_max = 0;                   // m
    std::uint32_t beam = 0;                // of the ranger, over all rings
    bool is_off_axis = false;              // of a cone, and not its axis
    bool is_turned = false;                // its sensor has angular noise
    std::uint32_t sensor = 0, sample = 0;  // which of its sensors, and which beam of all its rings
  };
  /// The beams of a sensor: those of its rings, from the lowest to the highest.
  struct Sensor {
    std::uint32_t first = 0, samples = 0, rings = 1, level = 0;
    double weakest = 0;     // power of an echo that it notices; 0: any, as surfaces are all alike to it
    double noise_weak = 0;  // m, of the weakest
  };
  std::vector<Sensor> sensors;
  std::vector<Ray> rays;
  std::vector<double> range_min, range_max;  // m (beams)
  bool is_narrow = false;                    // neighbouring rays differ little
  bool is_noisy = false;                     // any sensor has noise along its beams
  bool is_light = false;                     // any sensor has the errors of a lidar
  std::size_t beams() const { return range_max.size(); }
};

LidarBeams beams_of(const scene::ModelDesc& ranger);

}  // namespace playhouse::arena
