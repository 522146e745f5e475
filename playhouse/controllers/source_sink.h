#pragma once

/// source makes flags up to its capacity, one at each update of its model; sink counts the flags it is given.
/// On models of any kind.

#include "playhouse/controllers/batch.h"

namespace playhouse::controllers {

class Source final : public BatchOf<Source> {
 public:
  Source() : BatchOf("source") {}

  void decide(world::World& world, std::size_t begin, std::size_t end) override;
  void deliver(world::World& world) override;

 private:
  friend BatchOf<Source>;
  static auto memory(auto&) { return std::tuple<>(); }
  /// Argument: the capacity, 1 if absent; more arguments are ignored, as Stage does.
  Result<void> join(world::World& world, const Post& post) override;
  void leave_rest(std::size_t i) { erase_at(i, model_, capacity_, update_ticks_, makes_); }
  void resolve(const world::World& world, std::size_t i) override { model_[i] = world.row(id(i)); }

  std::vector<world::ModelRow> model_;
  std::vector<std::int32_t> capacity_;
  std::vector<std::uint64_t> update_ticks_;  // of the model
  std::vector<std::uint8_t> makes_;          // a flag, in this tick
};

class Sink final : public BatchOf<Sink> {
 public:
  Sink() : BatchOf("sink") {}

  /// Says "received N" whenever N grows.
  void decide(world::World& world, std::size_t begin, std::size_t end) override;
  void deliver(world::World& world) override;

 private:
  friend BatchOf<Sink>;
  static auto memory(auto& self) { return std::tie(self.before_, self.received_); }
  Result<void> join(world::World& world, const Post& post) override;
  void leave_rest(std::size_t i) { erase_at(i, model_, says_); }
  void resolve(const world::World& world, std::size_t i) override { model_[i] = world.row(id(i)); }

  std::vector<world::ModelRow> model_;
  std::vector<std::uint8_t> says_;  // how many, in this tick
  std::string text_;

  // Memory.
  std::vector<std::int32_t> before_;     // flags it held in the last tick
  std::vector<std::uint64_t> received_;  // since the start
};

}  // namespace playhouse::controllers
