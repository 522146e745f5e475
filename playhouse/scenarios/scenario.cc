#include "playhouse/scenarios/scenario.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>

#include "playhouse/base/in_quotes.h"
#include "playhouse/base/nearest_word.h"
#include "playhouse/scenarios/embedded.h"
#include "playhouse/scenarios/start_poses.h"
#include "playhouse/scene/world_loader.h"

namespace playhouse::scenarios {
namespace {

constexpr double kCaveSide = 16;          // m
constexpr std::size_t kCaveRobots = 100;  // more make the cave larger

std::string meters(double value) {
  return std::to_string(value);
}

/// Four walls around a square of `side` metres about the origin.
std::string walls(double side) {
  const double thick = 0.2, at = (side + thick) / 2, length = side + 2 * thick;
  const auto wall = [](double x, double y, double size_x, double size_y) {
    return "wall( pose [" + meters(x) + " " + meters(y) + " 0 0] size [" + meters(size_x) + " " +
           meters(size_y) + " 0.6] )\n";
  };
  return "define wall model ( color \"DimGray\" )\n" + wall(0, at, length, thick) +
         wall(0, -at, length, thick) + wall(at, 0, thick, side) + wall(-at, 0, thick, side);
}

/// The scene without its robots but one, which ends the text: the model all others are copied from.
std::string world_text(std::string_view name, double side) {
  const std::string head = "name \"" + std::string(name) +
                           "\"\ninterval_sim 100\n"
                           "include \"pioneer.inc\"\ninclude \"sick.inc\"\ninclude \"map.inc\"\n"
                           "window( center [0 0] scale " +
                           meters(std::clamp(900 / side, 1.0, 100.0)) + " show_data 0 )\n";
  if (name == "sonar") return head + walls(side) + "pioneer2dx( name \"r\" ctrl \"expand_swarm\" )\n";
  if (name == "laser") {
    return head + walls(side) + "pioneer2dx_bare( name \"r\" sicklaser_low() ctrl \"wander\" )\n";
  }
  return head + "floorplan( name \"cave\" bitmap \"bitmaps/cave.png\" size [" + meters(side) + " " +
         meters(side) + " 0.6] )\npioneer2dx( name \"r\" sicklaser() ctrl \"expand_pioneer\" )\n";
}

/// A colour of the rainbow for each robot.
scene::Color paint(std::size_t robot) {
  const double hue =
      static_cast<double>(robot) * 0.61803398875 * geom::kTwoPi;  // golden ratio: neighbours differ
  const auto channel = [&](double shift) {
    return static_cast<float>(0.55 + 0.4 * geom::sincos(hue + shift).cos);
  };
  return {channel(0), channel(geom::kTwoPi / 3), channel(2 * geom::kTwoPi / 3), 1};
}

/// Puts robots like the one at the scene's end, "r", at these poses in its place: "r0", "r1", ...
void replace_robot(scene::SceneDesc& scene, const std::vector<geom::Pose>& poses) {
  scene::TreeDesc robot = scene.trees.back();
  PLAYHOUSE_ASSERT(robot.name == "r");
  scene.trees.pop_back();
  scene.trees.reserve(scene.trees.size() + poses.size());
  for (std::size_t k = 0; k < poses.size(); ++k) {
    robot.name = robot.alias = fmt::format("r{}", k);
    robot.X_WM = poses[k];
    robot.color = paint(k);
    scene.trees.push_back(robot);
  }
}

Result<std::vector<geom::Pose>> cave_poses(std::size_t robots, double side, const std::string& png) {
  const Result<scene::Bitmap> rock = scene::decode_bitmap(png);
  if (!rock) return rock.error();
  std::vector<geom::Pose> poses = in_cave(robots, *rock, side);
  PLAYHOUSE_ASSERT(poses.size() == robots);
  return poses;
}

}  // namespace

const Scenario* find(std::string_view name) {
  const auto at =
      std::find_if(kScenarios.begin(), kScenarios.end(), [&](const Scenario& s) { return s.name == name; });
  return at == kScenarios.end() ? nullptr : &*at;
}

Result<scene::SceneDesc> make(std::string_view name, std::size_t robots) {
  if (!find(name)) {
    std::vector<std::string_view> names;
    for (const Scenario& scenario : kScenarios) names.push_back(scenario.name);
    return Error{{}, "no scenario " + in_quotes(name) + did_you_mean(name, names)};
  }
  if (robots < 1 || robots > kMostRobots) {
    return Error{
        {}, "robots must be from 1 to " + std::to_string(kMostRobots) + ", not " + std::to_string(robots)};
  }
  const bool cave = name == "cave";
  const double count = static_cast<double>(robots);
  const double side =
      cave ? kCaveSide * std::sqrt(std::max(1.0, count / kCaveRobots)) : std::sqrt(count / kDensity);
  const std::map<std::string, std::string> files = embedded_files();
  scene::MemoryFiles reader(files);
  const std::string path = "worlds/" + std::string(name) + ".world";
  Result<scene::SceneDesc> scene = scene::load_world_text(world_text(name, side), path, reader);
  if (!scene) return scene;
  Result<std::vector<geom::Pose>> poses =
      cave ? cave_poses(robots, side, files.at("worlds/bitmaps/cave.png")) : in_square(robots, side);
  if (!poses) return poses.error();
  replace_robot(*scene, *poses);
  return scene;
}

}  // namespace playhouse::scenarios
