#pragma once

/// Maps of ROS: a .yaml file beside an image, as map_server and nav2 read and write them.
/// Source: the documentation and map_io.cpp of nav2_map_server: image, resolution, origin, negate,
/// occupied_thresh, free_thresh, mode. A pixel is as light as the mean of its colours, in mode trinary with
/// its alpha as one more; it is occupied by (255 - light) / 255, or by light / 255 where it is negated. In
/// mode scale what one can see through is unknown; in mode raw `light` is the occupancy: 0 free, 100
/// occupied, above it unknown.

#include <string>
#include <string_view>

#include "playhouse/scene/plan.h"

namespace playhouse::scene {

/// What the .yaml file says.
struct RosMap {
  std::string image;  // its path, as it stands there
  double resolution = 0;
  geom::Pose origin;  // of the lower left corner of the image, in the world
  bool negate = false;
  double occupied = 0.65, free = 0.25;  // from 0 to 1: above it is a wall, below it is free
  std::string mode = "trinary";
};

/// Fails with the line and what is wrong there.
Result<RosMap> read_ros_map(const std::string& text);

/// The plan of a map whose image has these bytes.
Result<Plan> plan_of_ros_map(const RosMap& map, std::string_view bytes, std::string name);

/// True if the image alone, as worlds read bitmaps, has the same walls as the plan.
bool is_plain(const Plan& plan, std::string_view bytes);

/// The .yaml file of a plan whose image is a pgm_of() of that name.
std::string ros_map_of(const Plan& plan, const std::string& image);

}  // namespace playhouse::scene
