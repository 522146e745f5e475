#include "playhouse/scenarios/scenario.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "playhouse/base/in_quotes.h"
#include "playhouse/base/nearest_word.h"
#include "playhouse/scenarios/embedded.h"
#include "playhouse/scenarios/hospital.h"
#include "playhouse/scenarios/start_poses.h"
#include "playhouse/scene/world_loader.h"

namespace playhouse::scenarios {
namespace {

constexpr double kCaveSide = 16;           // m
constexpr std::size_t kCaveRobots = 100;   // per cave
constexpr double kDiffusionDensity = 2.5;  // robots per square metre: ten in 2 m x 2 m, as in ARGoS's example
constexpr double kSwarmDensity = 0.25;     // robots per square metre, as in wards
constexpr double kSwarmBotRadius = 0.0708;  // m
constexpr double kFootBotRadius = 0.085;    // m

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

std::string head(std::string_view name, double side) {
  return "name \"" + std::string(name) +
         "\"\ninterval_sim 100\n"
         "include \"pioneer.inc\"\ninclude \"sick.inc\"\ninclude \"map.inc\"\n"
         "include \"swarmbot.inc\"\ninclude \"footbot.inc\"\n"
         "window( center [0 0] scale " +
         meters(std::clamp(900 / side, 1.0, 100.0)) + " show_data 0 )\n";
}

/// A scene text that ends with one room, "room", if any,
/// and one robot, "r", and the places for their copies.
struct Draft {
  std::string text;
  std::vector<geom::Pose> rooms, robots;
};

/// A distinct hue for each robot.
scene::Color paint(std::size_t robot) {
  const double hue =
      static_cast<double>(robot) * 0.61803398875 * geom::kTwoPi;  // golden ratio: neighbours differ
  const auto channel = [&](double shift) {
    return static_cast<float>(0.55 + 0.4 * geom::sincos(hue + shift).cos);
  };
  return {channel(0), channel(geom::kTwoPi / 3), channel(2 * geom::kTwoPi / 3), 1};
}

/// Replaces the robot "r" by copies "r0", "r1", ... at the given places; likewise rooms.
void copy_models(scene::SceneDesc& scene, const Draft& draft) {
  scene::TreeDesc robot = std::move(scene.trees.back());
  PLAYHOUSE_ASSERT(robot.name == "r");
  scene.trees.pop_back();
  scene.trees.reserve(scene.trees.size() + draft.rooms.size() + draft.robots.size());
  if (!draft.rooms.empty()) {
    scene::TreeDesc room = std::move(scene.trees.back());
    PLAYHOUSE_ASSERT(room.name == "room");
    scene.trees.pop_back();
    for (std::size_t k = 0; k < draft.rooms.size(); ++k) {
      room.name = room.alias = fmt::format("room{}", k);
      room.X_WM = draft.rooms[k];
      scene.trees.push_back(room);
    }
  }
  for (std::size_t k = 0; k < draft.robots.size(); ++k) {
    robot.name = robot.alias = fmt::format("r{}", k);
    robot.X_WM = draft.robots[k];
    robot.color = paint(k);
    scene.trees.push_back(robot);
  }
}

/// Caves on a square grid around the origin.
Result<Draft> draft_cave(std::size_t robots, const std::string& png) {
  const std::size_t caves = (robots + kCaveRobots - 1) / kCaveRobots;
  const auto columns = static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(caves))));
  const double side = kCaveSide * static_cast<double>(columns);
  const Result<scene::Bitmap> rock = scene::decode_bitmap(png);
  if (!rock) return rock.error();
  std::vector<geom::Pose> rooms;
  for (std::size_t k = 0; k < caves; ++k)
    rooms.push_back({(static_cast<double>(k % columns) + 0.5) * kCaveSide - side / 2,
                     (static_cast<double>(k / columns) + 0.5) * kCaveSide - side / 2, 0, 0});
  return Draft{head("cave", side) + "floorplan( name \"room\" bitmap \"bitmaps/cave.png\" size [" +
                   meters(kCaveSide) + " " + meters(kCaveSide) +
                   " 0.6] )\npioneer2dx( name \"r\" sicklaser() ctrl \"expand_pioneer\" )\n",
               rooms, in_caves(robots, *rock, kCaveSide, kCaveRobots, rooms)};
}

Draft draft_hospital(std::size_t robots) {
  const Wards wards = wards_for(robots);
  return {head("hospital", static_cast<double>(wards.columns) * kWardWidth) + walls_of(wards) +
              "swarmbot( name \"r\" ctrl \"expand_swarm\" )\n",
          places_of(wards), in_wards(robots, wards)};
}

/// Large and fast bodies outside the walls of a square, 30 m and more from them: out of everybody's reach.
std::string large_and_fast(double side) {
  const auto body = [&](std::string_view name, double east, const std::string& words) {
    return "position( name \"" + std::string(name) + "\" pose [" + meters(side / 2 + east) + " 0 0 0] " +
           words + " )\n";
  };
  return body("car", 35, "size [4.5 1.8 1.5]") + body("truck", 60, "size [16 3 1]") +
         body("base", 120, "size [60 60 1]") +
         body("racer", 250,
              "size [0.4 0.4 0.3] velocity_bounds [-20 20 0 0 0 0 -90 90] velocity [20 0 0 30] alwayson 1") +
         body("crane", 350,
              "size [1 1 1] velocity [0 0 0 57] alwayson 1 model( pose [6 0 0 0] size [0.5 0.5 0.5] )");
}

/// `robots` copies of `robot` in a walled square.
Draft draft_square(std::string_view name, std::size_t robots, double density, double radius,
                   const std::string& robot) {
  const double side = std::sqrt(static_cast<double>(robots) / density);
  const std::string others = name == "mixed" ? large_and_fast(side) : "";
  return {head(name, side) + walls(side) + others + robot, {}, in_square(robots, side, radius)};
}

Result<Draft> draft(std::string_view name, std::size_t robots,
                    const std::map<std::string, std::string>& files) {
  if (name == "cave") return draft_cave(robots, files.at("worlds/bitmaps/cave.png"));
  if (name == "hospital") return draft_hospital(robots);
  if (name == "swarm" || name == "mixed")
    return draft_square(name, robots, kSwarmDensity, kSwarmBotRadius,
                        "swarmbot( name \"r\" ctrl \"expand_swarm\" )\n");
  if (name == "diffusion")
    return draft_square(name, robots, kDiffusionDensity, kFootBotRadius,
                        "footbot( name \"r\" ctrl \"diffusion\" )\n");
  return draft_square(name, robots, kDensity, kRobotRadius,
                      name == "sonar" ? "pioneer2dx( name \"r\" ctrl \"expand_swarm\" )\n"
                                      : "pioneer2dx_bare( name \"r\" sicklaser_low() ctrl \"wander\" )\n");
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
  const std::map<std::string, std::string> files = embedded_files();
  const Result<Draft> drafted = draft(name, robots, files);
  if (!drafted) return drafted.error();
  config::MemoryFiles reader(files);
  const std::string path = "worlds/" + std::string(name) + ".world";
  Result<scene::SceneDesc> scene = scene::load_world_text(drafted->text, path, reader);
  if (!scene) return scene;
  copy_models(*scene, *drafted);
  return scene;
}

}  // namespace playhouse::scenarios
