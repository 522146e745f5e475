#pragma once

/// Decider: one kind of in-process controller, for all the robots that run it. World owns the deciders; the engine
/// runs each of them over ranges of its robots in the decide phase, before act. Implemented by playhouse/controllers.

#include <cstddef>

#include "playhouse/base/hash.h"

namespace playhouse::world {

class World;

class Decider {
 public:
  virtual ~Decider() = default;

  /// How many robots it decides for; fixed once the world runs.
  virtual std::size_t size() const = 0;

  /// Decides for its robots begin .. end-1: reads the frozen state N of any model, writes the commands, flags and
  /// speech of those robots alone, and its own columns of them. Random numbers are functions of (seed, tick, robot).
  /// Disjoint ranges of one decider may run in parallel; deciders run one after the other, in the World's order.
  /// Never throws, allocates nothing.
  virtual void decide(World& world, std::size_t begin, std::size_t end) = 0;

  /// Adds what a later tick depends on; part of World::hash().
  virtual void hash(Hash& hash) const = 0;
};

}  // namespace playhouse::world
