/// What controllers of one tick see of each other.

#include "playhouse/behaviour/phased_engine.h"

#include <gtest/gtest.h>

namespace playhouse::behaviour {
namespace {

constexpr std::uint32_t kModels = 1000;

/// Nothing is anywhere.
class Nowhere final : public PhasedEngine {
 public:
  using PhasedEngine::PhasedEngine;
  std::uint64_t rays() const override { return 0; }

 private:
  void ingest(std::span<const world::Event>) override {}
  void move() override {}
  void sense(std::uint64_t) override {}
  void touching(world::ModelRow, const world::ByModel<std::uint8_t>&,
                std::vector<world::ModelRow>&) const override {}
};

/// Decides for every model: counts flags and letters of its neighbours, gives it a flag and a longer text.
class Neighbour final : public world::Decider {
 public:
  std::string_view name() const override { return "neighbour"; }
  std::size_t size() const override { return kModels; }
  void follow(world::World&) override {}
  void decide(world::World& world, std::size_t begin, std::size_t end) override {
    for (std::size_t i = begin; i < end; ++i) {
      seen_[i] = 0;
      for (const std::size_t next : {i + 1, i + 7, i + kModels - 1}) {
        const world::ModelRow row{static_cast<std::uint32_t>(next % kModels)};
        seen_[i] += world.models.flags[row] + static_cast<std::int64_t>(world.models.say[row].size());
      }
    }
  }
  void deliver(world::World& world) override {
    for (std::uint32_t i = 0; i < kModels; ++i) {
      world::add_flags(world, {i}, 1);
      world::set_say(world, {i}, std::string(world.tick() + 1, '!'));
    }
  }
  void hash(const world::World&, Hash&) const override {}
  Result<void> save(Packer&) const override { return {}; }
  bool load(world::World&, Unpacker&) override { return true; }

  const std::vector<std::int64_t>& seen() const { return seen_; }

 private:
  std::vector<std::int64_t> seen_ = std::vector<std::int64_t>(kModels);
};

TEST(PhasedEngine, shows_controllers_flags_and_texts_of_the_tick_before_whatever_their_order_and_workers) {
  scene::SceneDesc scene;
  scene.models.resize(kModels);
  for (const unsigned workers : {1u, 3u}) {
    Nowhere engine(scene, 1, workers);
    world::World& world = engine.world();
    std::vector<const Neighbour*> neighbours;
    for (int k = 0; k < 2; ++k) {
      auto made = std::make_unique<Neighbour>();
      neighbours.push_back(made.get());
      world.deciders.push_back(std::move(made));
    }
    for (std::int64_t tick = 0; tick < 5; ++tick) {
      engine.step();
      // Of each of three, as many flags as the two gave in every tick, and as many letters as ticks were
      // over.
      const std::vector<std::int64_t> expected(kModels, 3 * (2 * tick + tick));
      for (const Neighbour* each : neighbours)
        EXPECT_EQ(each->seen(), expected) << "tick " << tick << ", " << workers << " workers";
    }
  }
}

}  // namespace
}  // namespace playhouse::behaviour
