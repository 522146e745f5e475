#pragma once

/// Scenarios: worlds with any number of robots, shared by tests, benches and
/// demonstrations. 100 ms ticks, poses without overlaps, a function of name and number.

#include <array>
#include <cstddef>
#include <string_view>

#include "playhouse/base/result.h"
#include "playhouse/scene/scene_desc.h"

namespace playhouse::scenarios {

/// Robots per square metre in the walled squares of `sonar` and `laser`.
inline constexpr double kDensity = 0.39;
inline constexpr std::size_t kMostRobots = 1000000;

struct Scenario {
  std::string_view name;
  std::string_view about;  // one-line description
  std::size_t robots;      // default
  double seconds;          // simulated, default
};

inline constexpr std::array<Scenario, 7> kScenarios{{
    {"sonar", "robots with 16 sonars of 5 m spread over a walled square (expand_swarm)", 1000, 60},
    {"laser", "robots with 180 laser beams of 8 m wander in a walled square (wander)", 1000, 60},
    {"cave", "robots with 16 sonars and an idle laser spread through the 16 m cave (expand_pioneer)", 100,
     60},
    {"hospital", "robots of 0.1 m with 12 infrared sensors spread through rooms and corridors (expand_swarm)",
     2000, 60},
    {"swarm", "robots of 0.1 m with 12 infrared sensors spread over a walled square (expand_swarm)", 10000,
     60},
    {"mixed",
     "the swarm, and outside its walls a car, a truck, a base of 60 m, a robot at 20 m/s and a crane of 6 m",
     10000, 60},
    {"diffusion", "foot-bots with 24 proximity sensors of 0.1 m in a walled square (diffusion)", 1000, 60},
}};

/// The scenario of that name with robots "r0", "r1", ... `cave` has one
/// cave per hundred robots, to keep density and surroundings constant.
/// Fails on an unknown name and on a number outside 1 .. kMostRobots.
Result<scene::SceneDesc> make(std::string_view name, std::size_t robots);

/// Entry of kScenarios, or null.
const Scenario* find(std::string_view name);

}  // namespace playhouse::scenarios
