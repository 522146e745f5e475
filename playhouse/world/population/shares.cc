#include "playhouse/world/population/shares.h"

#include <fmt/format.h>

#include <algorithm>

#include "playhouse/base/limits.h"
#include "playhouse/world/population/population.h"

namespace playhouse::world {

Result<void> Shares::check(const World& world, const std::string& peer,
                           std::span<const std::uint32_t> coming) {
  if (const auto found = shares_.find(peer); found != shares_.end()) {
    NodeTrees& share = found->second;
    Amount more;
    for (const std::uint32_t desc : coming) add_to(more, amount_of(world, desc));
    if (is_too_much(share.sum, more) && share.population != world.population()) forget_removed(world, share);
    if (is_too_much(share.sum, more))
      return Error{
          {},
          fmt::format("your share of the run is full: you brought {} models with {} sensors and {} beams",
                      share.sum.models, share.sum.sensors, share.sum.beams)};
    share.counted_at = std::min(share.counted_at, world.time());  // later after a rewind
    if (brings_left(world, share) < 1)
      return Error{
          {},
          fmt::format("you bring too much at a time: {} models a second of the run, after {} at once",
                      limits::kBringsPerSecond, limits::kBringsAtOnce)};
  }
  return check_budget(world);
}

void Shares::add(const World& world, const std::string& peer, ModelId root) {
  const ModelRow row = world.row(root);
  if (peer.empty() || !row) return;
  if (!shares_.contains(peer)) {
    // Peers come and go: a share of which nothing is left is forgotten.
    for (auto& [other, share] : shares_) forget_removed(world, share);
    std::erase_if(shares_, [&](const auto& each) {
      return each.second.trees.empty() && brings_left(world, each.second) >= limits::kBringsAtOnce;
    });
  }
  NodeTrees& share = shares_[peer];
  const Amount amount = amount_of(world, world.models.desc[row]);
  share.trees.push_back({root, amount});
  add_to(share.sum, amount);
  share.brings_left = brings_left(world, share) - static_cast<double>(amount.models);
  share.counted_at = world.time();
}

double Shares::brings_left(const World& world, const NodeTrees& share) {
  const double passed = std::max(0.0, world.time() - share.counted_at);
  return std::min(limits::kBringsAtOnce, share.brings_left + limits::kBringsPerSecond * passed);
}

/// Of the tree as it is described.
Shares::Amount Shares::amount_of(const World& world, std::uint32_t desc) {
  Amount amount{.models = scene::tree_size(world.scene(), desc)};
  for (std::uint32_t part = 0; part < amount.models; ++part)
    for (const scene::RangerSensorDesc& sensor : world.scene().models[desc + part].sensors) {
      ++amount.sensors;
      amount.beams += sensor.samples;
    }
  return amount;
}

void Shares::add_to(Amount& sum, const Amount& amount) {
  sum.models += amount.models;
  sum.sensors += amount.sensors;
  sum.beams += amount.beams;
}

bool Shares::is_too_much(const Amount& share, const Amount& coming) {
  return share.models + coming.models > limits::kBroughtByOneModels ||
         share.sensors + coming.sensors > limits::kBroughtByOneSensors ||
         share.beams + coming.beams > limits::kBroughtByOneBeams;
}

void Shares::forget_removed(const World& world, NodeTrees& share) {
  std::erase_if(share.trees, [&](const Tree& tree) { return !world.row(tree.root); });
  share.sum = {};
  for (const Tree& tree : share.trees) add_to(share.sum, tree.amount);
  share.population = world.population();
}

}  // namespace playhouse::world
