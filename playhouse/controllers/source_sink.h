#pragma once

/// source produces flags up to its capacity, one per update of its
/// model; sink counts the flags it receives. For models of any kind.

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
  /// Argument: the capacity, default 1; further arguments are ignored, as in Stage.
  Result<void> join(world::World& world, const Post& post) override;
  void leave_rest(std::size_t i) { erase_at(i, model_, capacity_, update_ticks_, makes_); }
  void resolve(const world::World& world, std::size_t i) override { model_[i] = world.row(id(i)); }

  std::vector<world::ModelRow> model_;
  std::vector<std::int32_t> capacity_;
  std::vector<std::uint64_t> update_ticks_;  // of the model
  std::vector<std::uint8_t> makes_;          // makes a flag in this tick
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
  std::vector<std::uint8_t> says_;  // says the count in this tick
  std::string text_;

  // Memory.
  std::vector<std::int32_t> before_;     // flags in the previous tick
  std::vector<std::uint64_t> received_;  // in total
};

}  // namespace playhouse::controllers
