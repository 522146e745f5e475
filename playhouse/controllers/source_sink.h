#pragma once

/// source makes flags up to its capacity, one a tick; sink counts the flags it is given. On models of any
/// kind.

#include "playhouse/controllers/batch.h"

namespace playhouse::controllers {

class Source final : public Batch {
 public:
  /// Argument: the capacity, 1 if absent; more arguments are ignored, as Stage does.
  Result<void> add(world::World& world, const Post& post) override;

  std::size_t size() const override { return model_.size(); }
  void decide(world::World& world, std::size_t begin, std::size_t end) override;
  void hash(Hash&) const override {}

 private:
  std::vector<world::ModelRow> model_;
  std::vector<std::int32_t> capacity_;
};

class Sink final : public Batch {
 public:
  Result<void> add(world::World& world, const Post& post) override;

  std::size_t size() const override { return model_.size(); }
  /// Says "received N" whenever N grows.
  void decide(world::World& world, std::size_t begin, std::size_t end) override;
  void hash(Hash& hash) const override;

 private:
  std::vector<world::ModelRow> model_;
  std::vector<std::int32_t> before_;     // flags it held in the last tick
  std::vector<std::uint64_t> received_;  // since the start
};

}  // namespace playhouse::controllers
