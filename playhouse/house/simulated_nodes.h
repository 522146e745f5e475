#pragma once

/// SimulatedNodes: nodes of the cluster that computes the run of a house: machines that join, crash, and are
/// cut off for a while. Thread: that of the house.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "playhouse/cluster/head.h"
#include "playhouse/net/polled/simulated_machines.h"

namespace playhouse::house {

class SimulatedNodes {
 public:
  explicit SimulatedNodes(std::uint64_t seed) : machines_(seed), random_(seed) {}

  /// The engine of the run with its head, which must not outlive this. `fail` hears that a node computes
  /// something else.
  std::unique_ptr<cluster::Head> head(std::unique_ptr<world::Engine> engine, config::SourceFiles sources,
                                      std::function<void(const std::string&)> fail);
  /// Some join, some crash.
  void act();
  void pass(double seconds) { machines_.pass(seconds); }
  /// Of the machines [s]: later than that of the house when a tick has waited for them.
  double now() const { return machines_.now(); }
  std::size_t joined() const { return machines_begun_; }

 private:
  std::uint32_t draw(std::uint32_t below) { return static_cast<std::uint32_t>(random_() % below); }

  net::SimulatedMachines machines_;
  std::mt19937_64 random_;
  std::size_t machines_begun_ = 0;
};

}  // namespace playhouse::house
