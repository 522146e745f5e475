#pragma once

/// ROS maps: a .yaml file with an image, as written by map_server and nav2.
/// Source: documentation and map_io.cpp of nav2_map_server: image, resolution, origin,
/// negate, occupied_thresh, free_thresh, mode. The brightness of a pixel is the mean of its
/// colour channels, in mode trinary including alpha; its occupancy is (255 - brightness) /
/// 255, or brightness / 255 if negated. In mode scale transparent pixels are unknown; in
/// mode raw the brightness is the occupancy: 0 free, 100 occupied, above that unknown.

#include <string>
#include <string_view>
#include <vector>

#include "playhouse/base/result.h"
#include "playhouse/scene/images/plan.h"

namespace playhouse::scene {

/// Contents of the .yaml file.
struct RosMap {
  std::string image;  // path, as in the file
  double resolution = 0;
  geom::Pose origin;  // pose of the image's lower left corner in W
  bool negate = false;
  double occupied = 0.65, free = 0.25;  // thresholds in 0 .. 1: above occupied is wall, below free is free
  std::string mode = "trinary";
  std::vector<Error> warnings;  // with lines: keys that have no effect
};

/// Fails with line and reason.
Result<RosMap> read_ros_map(const std::string& text);

/// The image of the map in the file `path`. An absolute path of another machine, as of the robot
/// that saved the map, gives way to the file of that name beside the map.
struct MapImage {
  std::string path;
  bool is_instead = false;  // of the one that the file names
};
MapImage image_of(const RosMap& map, const std::string& path);

/// True for names of .yaml files.
bool is_map_name(std::string_view name);

/// The plan of a map with this image.
Result<Plan> plan_of_ros_map(const RosMap& map, std::string_view bytes, std::string name);

/// True if the image loaded as a bitmap has the same walls as the plan.
bool is_plain(const Plan& plan, std::string_view bytes);

/// The .yaml file of a plan with the image pgm_of() under that name.
std::string ros_map_of(const Plan& plan, const std::string& image);

}  // namespace playhouse::scene
