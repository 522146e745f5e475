#pragma once

/// Shares: what each peer brought to a run, so that no peer takes all that may be brought. Thread: the tick
/// thread, between steps.

#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "playhouse/base/limits.h"
#include "playhouse/base/result.h"
#include "playhouse/world/world.h"

namespace playhouse::world {

class Shares {
 public:
  /// For trees like these (rows of descriptions) that this peer asks for, before they are spawned: fails as
  /// check_budget(), and if they and what the peer brought and what still exists are more than one may bring
  /// (base/limits.h, kBroughtByOne...). "": a driver of
  /// the program, which has no share. Also fails while the peer brings more often than one may (kBrings...),
  /// by the time of the run. Cost: the models that come, and the peer's trees, if models were removed since a
  /// full share was last counted.
  Result<void> check(const World& world, const std::string& peer, std::span<const std::uint32_t> coming);
  /// After it: counts the tree of this root, until it is removed, whoever removes it.
  void add(const World& world, const std::string& peer, ModelId root);

 private:
  struct Amount {
    std::size_t models = 0, sensors = 0, beams = 0;
  };
  struct Tree {
    ModelId root;
    Amount amount;
  };
  struct NodeTrees {
    std::vector<Tree> trees;
    Amount sum;
    std::uint64_t population = 0;  // World::population() of the sum
    double brings_left = limits::kBringsAtOnce;
    double counted_at = 0;  // s of the run; brings_left then
  };
  static Amount amount_of(const World& world, std::uint32_t desc);
  static void add_to(Amount& sum, const Amount& amount);
  static bool is_too_much(const Amount& share, const Amount& coming);
  static void forget_removed(const World& world, NodeTrees& share);
  static double brings_left(const World& world, const NodeTrees& share);

  std::map<std::string, NodeTrees> shares_;
};

}  // namespace playhouse::world
