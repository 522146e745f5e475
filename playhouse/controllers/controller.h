#pragma once

/// Controller: base class of user code that controls a robot inside the simulation. Build it
/// as a shared library and name it in a world file, `ctrl "shy 0.3"` for shy.so with the
/// argument "0.3"; docs/controllers.md is a tutorial. The only header a controller includes;
/// changes only together with kControllerVersion; libraries built for versions from
/// kControllerVersionLeast on still load. One object per robot. Objects of different robots
/// may run in parallel, so do not share mutable state; use Robot::random and Robot::time, and
/// runs are bit-reproducible. Frames: O odometry (W if the robot localises by "gps"), R robot.

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "playhouse/base/rng.h"
#include "playhouse/geom/pose.h"

namespace playhouse::controllers {

inline constexpr std::uint32_t kControllerVersion = 2;
inline constexpr std::uint32_t kControllerVersionLeast = 1;

/// The beams of one ranger: a laser's from right to left, or one per sonar.
struct Ranger {
  std::string_view name;            // "r0.ranger:1"
  std::span<const float> ranges;    // m; range_max: no hit
  std::span<const float> bearings;  // rad, by beam, in R
  float range_max = 0;              // m, the largest of its sensors
  bool fresh = false;               // measured since the last decide()
  bool used = true;                 // set false in start() to leave it unsubscribed
};

/// A detection of a fiducial finder.
struct Sighting {
  int id = 0;          // 0: out of identification range
  double range = 0;    // m
  double bearing = 0;  // rad, in the finder's frame
  double heading = 0;  // rad, of the marker, in the finder's frame
};

/// The controller's view of a robot: measurements, updated before every call, and commands.
struct Robot {
  // Constant.
  std::string_view name;
  std::span<const std::string> arguments;  // words after the controller's name
  std::span<Ranger> rangers;               // in file order

  // Measurements.
  double time = 0;       // s, simulated
  double dt = 0;         // s, one tick
  geom::Pose pose;       // X_OR, odometry
  geom::Twist velocity;  // m/s and rad/s, in R
  bool stalled = false;  // its last motion was blocked
  std::span<const Sighting> sightings;
  Rng random{0};  // a stream per robot, controller and tick

  // Commands. Each remains in effect until the next one.
  void drive(double forward, double turn) { drive(geom::Twist{forward, 0, 0, turn}); }
  void drive(const geom::Twist& wanted) { order = Order::kDrive, twist = wanted; }
  void go_to(const geom::Pose& X_OR) { order = Order::kGoTo, goal = X_OR; }
  int flags = 0;    // tokens carried
  std::string say;  // its speech bubble

  // Set by drive() and go_to(), read by the simulation.
  enum class Order : std::uint8_t { kNone, kDrive, kGoTo } order = Order::kNone;
  geom::Twist twist;
  geom::Pose goal;
};

class Controller {
 public:
  virtual ~Controller() = default;

  /// Called once, before the first tick. A std::exception rejects the robot; its text is shown to the user.
  virtual void start(Robot&) {}

  /// Called once per tick. An exception ends the controller and stops its robot.
  virtual void decide(Robot& robot) = 0;

  // Since version 2; called between ticks.

  /// Serialises all state kept between ticks into `memory`, in any format, so that a
  /// saved run continues identically; true also if there is none. The default, false,
  /// makes runs with this controller impossible to save, which is reported with its name.
  virtual bool save(std::string& memory) const { return static_cast<void>(memory), false; }
  /// Restores what save() wrote, after start(), maybe in
  /// another process. Throw a std::exception on invalid data: the controller is then
  /// ended, as one that throws elsewhere, and the state is loaded.
  virtual void load(std::string_view memory) { static_cast<void>(memory); }
};

}  // namespace playhouse::controllers

/// Exports the class that a library provides; use it once, outside any namespace.
#define PLAYHOUSE_CONTROLLER(Type)                                                                 \
  extern "C" __attribute__((visibility("default"))) std::uint32_t playhouse_controller_version() { \
    return ::playhouse::controllers::kControllerVersion;                                           \
  }                                                                                                \
  extern "C" __attribute__((visibility("default"))) ::playhouse::controllers::Controller*          \
  playhouse_controller_make() {                                                                    \
    return new Type;                                                                               \
  }
