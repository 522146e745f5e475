#pragma once

/// Floor plans: images in which walls are dark, with what a pixel measures, as worlds. A plan comes from an
/// image and a scale, or from a map of ROS (ros_map.h).

#include <string>

#include "playhouse/geom/pose.h"
#include "playhouse/scene/bitmap.h"

namespace playhouse::scene {

struct Plan {
  std::string name;
  Bitmap solid;       // what is a wall
  Bitmap free;        // where somebody can be: neither wall nor unknown; of the same size
  double resolution;  // m per pixel
  geom::Pose X_WI;    // the lower left corner of the image, and how it is turned, in the world
};

/// A plan whose image is about the origin of the world. Fails on bytes that are no image.
Result<Plan> plan_of_image(std::string_view bytes, std::string name, double resolution);

/// A world file: the plan's walls, `height` metres high, from the image that the file is to find as `bitmap`,
/// and a robot with a laser in the free place that is nearest to the middle of the plan. Fails on a plan
/// without walls and on a name that a world file cannot hold.
Result<std::string> world_of_plan(const Plan& plan, const std::string& bitmap, double height);

/// The walls as a PGM image, black on white.
std::string pgm_of(const Bitmap& solid);

}  // namespace playhouse::scene
