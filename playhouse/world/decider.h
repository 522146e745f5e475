#pragma once

/// Decider: one kind of in-process controller, for all the robots that run it. World owns the deciders; the
/// engine runs each of them over ranges of its robots in the decide phase, before act, then lets each
/// deliver, and filter after sense. Implemented by playhouse/controllers.

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

  /// As world files name it: "wander".
  virtual std::string_view name() const = 0;

  /// How many robots it decides for; changes in follow() alone.
  virtual std::size_t size() const = 0;

  /// Takes in the changes since it was last called: models that came and name it, models that went, rows that
  /// moved. Called by the engine before decide(), alone.
  virtual void follow(World& world) = 0;

  /// Decides for its robots begin .. end-1: reads the frozen state N of any model; writes the commands of
  /// those robots, which nobody reads before `act`, and its own columns of them. What it gives to models
  /// beyond that waits there for deliver(). Random numbers are functions of (seed, tick, robot). Disjoint
  /// ranges of one decider may run in parallel; deciders run one after the other, in the World's order. Never
  /// throws, allocates nothing.
  virtual void decide(World& world, std::size_t begin, std::size_t end) = 0;

  /// Gives models what decide() has for them, with the functions of world.h: flags, texts. Called alone, when
  /// all deciders have decided, in the World's order; goes through its robots in the order of their ids. Who
  /// decides sees it in the next tick. Never throws, allocates nothing that it does not keep.
  virtual void deliver(World& world) { static_cast<void>(world); }

  /// Whether filter() does anything: who does not is not asked in every tick.
  virtual bool filters() const { return false; }
  /// Changes what models begin .. end-1 of its own have just measured, before anybody sees it: the state is
  /// that of the next tick but for its number, and rangers.measured_tick tells what is new. Called as
  /// decide().
  virtual void filter(World& world, std::size_t begin, std::size_t end) {
    static_cast<void>(world), static_cast<void>(begin), static_cast<void>(end);
  }

  /// Adds what a later tick depends on; part of World::hash(). A sum over robots, named by serial number.
  virtual void hash(const World& world, Hash& hash) const = 0;

  /// Writes what a later tick depends on. Fails where a controller cannot say.
  virtual Result<void> save(Packer& out) const = 0;
  /// Reads what save() wrote; the world has the state's models already. False: it is no such thing.
  virtual bool load(World& world, Unpacker& in) = 0;
};

}  // namespace playhouse::world
