#pragma once

/// CustomKind: the code of models and sensors from shared libraries (kind `custom`, kinds/custom.toml), as
/// the engine calls it. A library includes custom_library.h, which has this and more; docs/libraries.md shows
/// how.

#include <atomic>
#include <cstdint>
#include <memory>
#include <span>
#include <string>

#include "playhouse/base/rng.h"
#include "playhouse/geom/pose.h"
#include "playhouse/scene/values.h"
#include "playhouse/world/models.h"

namespace playhouse::world {

class Surroundings;
class World;

/// Raised whenever something in this header or in surroundings.h changes.
inline constexpr std::uint32_t kCustomVersion = 1;

/// A model as its library's code sees it. Of the world, all columns may be read that an earlier phase wrote
/// (columns.h says who writes what), but none of other rows of world.customs.
struct CustomModel {
  const World& world;
  ModelRow model;
  double time = 0;                  // s, simulated, of the state that is made
  double dt = 0;                    // s, one tick
  bool used = false;                // somebody other than people who only look has subscribed it
  std::span<const double> command;  // what clients set last, each a number from CMD STATE of interface aio
  Rng random{0};                    // differs for every model, hook and tick, and repeats with the seed
};

/// For act().
struct CustomActor : CustomModel {
  std::span<double> state;
  geom::Twist velocity;  // in M, for this tick; what is in the way stops it
  bool stalled = false;  // its last motion was blocked
  scene::Color color;    // of its body
};

/// For sense().
struct CustomSensor : CustomModel {
  std::span<const double> state;
  const Surroundings& around;
  std::span<double> readings;  // those of the last time, to begin with
};

/// One object for all models that are alike (of one row of SceneDesc::models), used by several threads at
/// once: it keeps nothing that a hook changes. What a model remembers is its state, and so rewinding, saved
/// runs, hashes and models that come and go need nothing here. A hook that throws, or leaves a number that is
/// not finite, has changed nothing; the first time is logged.
class CustomKind {
 public:
  /// How many numbers a model has of each; at most limits::kCustomNumbers.
  struct Sizes {
    std::uint32_t commands = 0, state = 0, readings = 0;
  };

  virtual ~CustomKind() = default;

  /// Once, before anything else, with the words behind the library's name in the world file. Throw a
  /// std::exception to refuse them; its text reaches the user.
  virtual Sizes configure(std::span<const std::string> arguments) = 0;

  /// Fills the state and the commands, which are 0, of a model that begins: in the tick after it came, and
  /// after a return to the start.
  virtual void begin(const CustomModel& self, std::span<double> state, std::span<double> command) const {
    static_cast<void>(self), static_cast<void>(state), static_cast<void>(command);
  }

  /// In every tick, before anything moves: from what it is told and the frozen world to its state, velocity
  /// and colour. What it measured it must not read: people who look change that.
  virtual void act(CustomActor& self) const { static_cast<void>(self); }

  /// When it is subscribed and its update_interval is over, after everything has moved.
  virtual void sense(CustomSensor& self) const { static_cast<void>(self); }
};

/// The code of models that are alike, with its library, which outlives it.
struct CustomCode {
  std::shared_ptr<const CustomKind> kind;
  CustomKind::Sizes sizes;
  mutable std::atomic_flag complained;  // something went wrong, and that is logged
};

}  // namespace playhouse::world
