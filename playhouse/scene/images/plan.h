#pragma once

/// Floor plans: images with dark walls and a scale, converted to worlds.
/// From an image and a resolution, or from a ROS map (ros_map.h).

#include <string>

#include "playhouse/geom/pose.h"
#include "playhouse/scene/images/bitmap.h"

namespace playhouse::scene {

struct Plan {
  std::string name;
  Bitmap solid;       // walls
  Bitmap free;        // free space: neither wall nor unknown; same size
  double resolution;  // m per pixel
  geom::Pose X_WI;    // pose in W of the image's lower left corner
};

/// A plan centred on the world's origin. Fails on bytes that are not an image.
Result<Plan> plan_of_image(std::string_view bytes, std::string name, double resolution);

/// A world file: the plan's walls, `height` metres high, from the image that the file
/// refers to as `bitmap`, and a robot with a laser in the largest connected free space, at the
/// place nearest to the centre. Fails on a plan without walls and on a name that a world file cannot contain.
Result<std::string> world_of_plan(const Plan& plan, const std::string& bitmap, double height);

/// The walls as a PGM image, black on white.
std::string pgm_of(const Bitmap& solid);

}  // namespace playhouse::scene
