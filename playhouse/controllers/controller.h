#pragma once

/// Controller: what you write to drive a robot from inside the simulation. Build it as a shared library and
/// name it in a world file, `ctrl "shy 0.3"` for shy.so with the argument "0.3"; docs/controllers.md shows
/// how. This header is all a controller includes, and changes only together with kControllerVersion;
/// libraries built for an older one from kControllerVersionLeast on still load. One object per robot. Objects
/// of different robots may run at the same time, so share nothing that changes; take random numbers from
/// Robot::random and time from Robot::time, and a run repeats to the bit. Frames: O odometry (the world, if
/// the robot localises by "gps"), R robot.

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "playhouse/base/rng.h"
#include "playhouse/geom/pose.h"

namespace playhouse::controllers {

inline constexpr std::uint32_t kControllerVersion = 2;
inline constexpr std::uint32_t kControllerVersionLeast = 1;

/// All beams of one ranger: a laser's from right to left, or one per sonar.
struct Ranger {
  std::string_view name;            // "r0.ranger:1"
  std::span<const float> ranges;    // m; range_max where nothing was hit
  std::span<const float> bearings;  // rad, of each beam in R
  float range_max = 0;              // m, the largest of its sensors
  bool fresh = false;               // measured since the last decide()
  bool used = true;                 // set false in start(): it then measures nothing for you
};

/// A marker that a fiducial finder sees.
struct Sighting {
  int id = 0;          // 0: too far to read
  double range = 0;    // m
  double bearing = 0;  // rad, in the finder's frame
  double heading = 0;  // rad, of the marker, in the finder's frame
};

/// A robot as its controller sees it: what it senses, refreshed before every call, and what it is told to do.
struct Robot {
  // Fixed.
  std::string_view name;
  std::span<const std::string> arguments;  // the words after the controller's name
  std::span<Ranger> rangers;               // in file order

  // Senses.
  double time = 0;       // s, simulated
  double dt = 0;         // s, one tick
  geom::Pose pose;       // X_OR, where it believes to be
  geom::Twist velocity;  // m/s and rad/s, in R
  bool stalled = false;  // its last motion was blocked
  std::span<const Sighting> sightings;
  Rng random{0};  // differs for every robot, controller and tick

  // Orders. A command stays in force until the next one.
  void drive(double forward, double turn) { drive(geom::Twist{forward, 0, 0, turn}); }
  void drive(const geom::Twist& wanted) { order = Order::kDrive, twist = wanted; }
  void go_to(const geom::Pose& X_OR) { order = Order::kGoTo, goal = X_OR; }
  int flags = 0;    // tokens it carries
  std::string say;  // its speech bubble

  // Filled by drive() and go_to(), read by the simulation.
  enum class Order : std::uint8_t { kNone, kDrive, kGoTo } order = Order::kNone;
  geom::Twist twist;
  geom::Pose goal;
};

class Controller {
 public:
  virtual ~Controller() = default;

  /// Once, before the first tick. Throw a std::exception to refuse the robot; its text reaches the user.
  virtual void start(Robot&) {}

  /// Once per tick. An exception ends the controller and stops its robot.
  virtual void decide(Robot& robot) = 0;

  // From version 2 on; called between ticks.

  /// Puts all that decide() remembers from tick to tick into `memory`, as bytes of any form, so that a run
  /// can be saved and goes on the same; true also if there is nothing to remember. False, as long as this is
  /// not overridden: a run with this controller cannot be saved, and who asks is told its name.
  virtual bool save(std::string& memory) const { return static_cast<void>(memory), false; }
  /// Remembers what save() put there, after start(), maybe in another run of the program. Throw a
  /// std::exception where it cannot be that.
  virtual void load(std::string_view memory) { static_cast<void>(memory); }
};

}  // namespace playhouse::controllers

/// Names the class that a library provides; write it once, outside any namespace.
#define PLAYHOUSE_CONTROLLER(Type)                                                                 \
  extern "C" __attribute__((visibility("default"))) std::uint32_t playhouse_controller_version() { \
    return ::playhouse::controllers::kControllerVersion;                                           \
  }                                                                                                \
  extern "C" __attribute__((visibility("default"))) ::playhouse::controllers::Controller*          \
  playhouse_controller_make() {                                                                    \
    return new Type;                                                                               \
  }
