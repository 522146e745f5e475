#pragma once

/// CustomKind: the interface between the engine and models or sensors of
/// shared libraries (kind `custom`, kinds/custom.toml). A library includes
/// custom_library.h, which includes this; docs/libraries.md is a tutorial.

#include <atomic>
#include <cstdint>
#include <memory>
#include <span>
#include <string>

#include "playhouse/base/rng.h"
#include "playhouse/geom/pose.h"
#include "playhouse/scene/text/values.h"
#include "playhouse/world/models.h"

namespace playhouse::world {

class Surroundings;
class World;

/// ABI version: increment on any change to this header or surroundings.h.
inline constexpr std::uint32_t kCustomVersion = 1;

/// The view of a model that its library's code gets. All columns that an earlier phase wrote
/// may be read (writers are in columns.h), except those of other rows of world.customs.
struct CustomModel {
  const World& world;
  ModelRow model;
  double time = 0;                  // s, simulated, of the state being computed
  double dt = 0;                    // s, one tick
  bool used = false;                // has a subscriber other than observers
  std::span<const double> command;  // latest command, each number set by CMD STATE of interface aio
  Rng random{0};                    // stream by model, hook and tick; reproducible from the seed
};

/// For act().
struct CustomActor : CustomModel {
  std::span<double> state;
  geom::Twist velocity;  // in M, for this tick; blocked by obstacles
  bool stalled = false;  // its last motion was blocked
  scene::Color color;    // of its body
};

/// For sense().
struct CustomSensor : CustomModel {
  std::span<const double> state;
  const Surroundings& around;
  std::span<double> readings;  // initially those of the previous measurement
};

/// One object serves all models of one row of SceneDesc::models from several threads, so
/// it must not hold mutable state. A model's memory is its `state` column; that makes
/// rewinding, saved runs, hashes and population changes work without further code. A hook
/// that throws or produces a non-finite number has no effect; the first failure is logged.
class CustomKind {
 public:
  /// Lengths of a model's arrays; each at most limits::kCustomNumbers.
  struct Sizes {
    std::uint32_t commands = 0, state = 0, readings = 0;
  };

  virtual ~CustomKind() = default;

  /// Called once, before anything else, with the arguments after the library's name in the
  /// world file. Throw a std::exception to reject them; its text is shown to the user.
  virtual Sizes configure(std::span<const std::string> arguments) = 0;

  /// Initialises state and commands, which are 0, of a new model:
  /// in the tick after its spawn, and after a return to the start.
  virtual void begin(const CustomModel& self, std::span<double> state, std::span<double> command) const {
    static_cast<void>(self), static_cast<void>(state), static_cast<void>(command);
  }

  /// Called in every tick before motion: computes state, velocity and colour from commands and
  /// the frozen world. It must not read its own measurements: those depend on who subscribes.
  virtual void act(CustomActor& self) const { static_cast<void>(self); }

  /// Called after motion when the sensor is subscribed and its update_interval has elapsed.
  virtual void sense(CustomSensor& self) const { static_cast<void>(self); }
};

/// The code of models that share a description, with its library, which outlives it.
struct CustomCode {
  std::shared_ptr<const CustomKind> kind;
  CustomKind::Sizes sizes;
  mutable std::atomic_flag complained;  // an error was logged already
};

}  // namespace playhouse::world
