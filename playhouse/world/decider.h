#pragma once

/// Decider: one kind of in-process controller, for all robots that run it. Owned by
/// World; the engine runs each over ranges of its robots in the decide phase, before
/// act, then deliver(), and filter() after sense. Implemented by playhouse/controllers.

#include <cstddef>
#include <string_view>

#include "playhouse/base/hash.h"
#include "playhouse/base/packing.h"
#include "playhouse/base/result.h"

namespace playhouse::world {

class World;

class Decider {
 public:
  virtual ~Decider() = default;

  /// Its name in world files: "wander".
  virtual std::string_view name() const = 0;

  /// Number of robots it controls; changed by follow() only.
  virtual std::size_t size() const = 0;

  /// Processes the event log since the previous call: models spawned with this controller,
  /// models removed, rows that moved. Called by the engine before decide(), sequentially.
  virtual void follow(World& world) = 0;

  /// Decides for its robots begin .. end-1: reads the frozen state N of any model; writes
  /// the commands of those robots, not read before `act`, and its own columns of
  /// them. Changes to other models are queued for deliver(). Random numbers are functions
  /// of (seed, tick, robot). Disjoint ranges of one decider may run in parallel; deciders
  /// run one after the other in the World's order. Must not throw or allocate.
  virtual void decide(World& world, std::size_t begin, std::size_t end) = 0;

  /// Applies queued changes to models with the functions of world.h: flags, texts. Called
  /// sequentially after all deciders, in the World's order; visits robots in the order of ids.
  /// Deciders see the effect in the next tick. Must not throw; allocates only what it keeps.
  virtual void deliver(World& world) { static_cast<void>(world); }

  /// Whether filter() does anything; if not, it is not called.
  virtual bool filters() const { return false; }
  /// Post-processes what its models begin .. end-1 have just measured, before
  /// anybody reads it: the state is that of the next tick except for its number,
  /// and rangers.measured_tick tells which are new. Same threading as decide().
  virtual void filter(World& world, std::size_t begin, std::size_t end) {
    static_cast<void>(world), static_cast<void>(begin), static_cast<void>(end);
  }

  /// Adds its state as far as later ticks depend on it; part of World::hash(). A sum over robots, which are
  /// named by serial number.
  virtual void hash(const World& world, Hash& hash) const = 0;

  /// Writes its state as far as later ticks depend on it. Fails if a controller cannot be saved.
  virtual Result<void> save(Packer& out) const = 0;
  /// Reads what save() wrote, after the state's models were loaded. False: invalid data.
  virtual bool load(World& world, Unpacker& in) = 0;
};

}  // namespace playhouse::world
