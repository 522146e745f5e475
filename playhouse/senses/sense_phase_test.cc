// Phases follow a population that changes: populated for one world and then for another, they measure there
// as phases that knew no other.

#include "playhouse/senses/sense_phase.h"

#include <gtest/gtest.h>

#include <string>
#include <utility>

#include "playhouse/senses/sense_fiducial.h"
#include "playhouse/senses/sense_ranger.h"
#include "playhouse/stage/testing_scenes.h"

namespace playhouse::senses {
namespace {

Senses all_senses() {
  Senses senses;
  add_senses(senses, 1);
  return senses;
}

/// What is measured in the first tick of a scene: the hash of it, and the rays.
std::pair<std::uint64_t, std::uint64_t> measure(Senses& senses, const scene::SceneDesc& scene) {
  world::World world(scene, 1);
  bodies::Trees trees = bodies::make_trees(world);
  const bodies::Solids solids = stage::testing::make_solids(world, trees);
  const bodies::Walls walls(solids);
  world::Workers workers(1);
  bodies::DiscIndex index;
  index.populate(solids.moving(), 0.3, {}, std::span(solids.radius).last(solids.moving()));
  index.rebuild(
      solids.moving(), [&](std::size_t i) { return disc_of(solids, solids.moving_rows()[i]); }, workers);
  const bodies::Space space{solids, index, walls};
  senses.populate(world, space);
  const std::uint64_t rays = senses.sense(world, space, 1, workers);
  return {world.sensed_hash(), rays};
}

void add_finder(scene::SceneDesc& scene) {
  scene::ModelDesc& model = scene.models.emplace_back();
  model.name = model.alias = "finder";
  model.kind = scene::ModelKind::kFiducial;
  model.alwayson = true;
  model.fiducial = scene::FiducialDesc{};
  for (scene::ModelDesc& other : scene.models) other.fiducial_return = 3;
}

TEST(Senses, measure_in_another_population_as_if_they_had_known_no_other) {
  std::vector<scene::SceneDesc> scenes = {stage::testing::crowd(5, stage::testing::Sensing::kSonar),
                                          stage::testing::crowd(40, stage::testing::Sensing::kLaser),
                                          stage::testing::crowd(60, stage::testing::Sensing::kSonar)};
  scenes.push_back(scenes[0]);
  add_finder(scenes[1]);
  scenes.push_back(
      stage::testing::crowd(20, stage::testing::Sensing::kSonar));  // a body for which tables are too small
  scenes.back().models.push_back(stage::testing::robot("large", {9, 9, 0, 0.4}, {3, 2, 1}));
  add_finder(scenes.back());
  scenes.push_back(scenes[2]);
  Senses used = all_senses();
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    Senses fresh = all_senses();
    const auto expected = measure(fresh, scenes[i]), got = measure(used, scenes[i]);
    EXPECT_EQ(got, expected) << "scene " << i;
    EXPECT_GT(got.second, 0u);
  }
}

/// Logs how many of the rangers it is to measure with.
class Counting final : public SensePhase {
 public:
  Counting(behaviour::Sharing sharing, std::vector<std::string>& log, std::string name)
      : sharing_(sharing), log_(log), name_(std::move(name)) {}
  SensorTable table(world::World& world) const override {
    ticks_.resize(world.rangers.size());
    return {world.rangers.model, ticks_};
  }
  void populate(const world::World&, const bodies::Space&) override {}
  behaviour::Sharing sharing() const override { return sharing_; }
  std::uint64_t sense(world::World&, const bodies::Space&, std::span<const world::KindRow> due, std::uint64_t,
                      world::Workers&) override {
    log_.push_back(name_ + std::to_string(due.size()));
    return due.size();
  }

 private:
  behaviour::Sharing sharing_;
  std::vector<std::string>& log_;
  std::string name_;
  mutable std::vector<std::uint64_t> ticks_;
};

/// One of two nodes; the other computes nothing.
class HalfOfTheWork final : public world::Division {
 public:
  HalfOfTheWork(std::size_t index, std::vector<std::string>& log) : index_(index), log_(log) {}
  void run(world::DividedWork& work) override {
    std::vector<std::byte> out;
    work.compute({index_, 2}, out);
    log_.emplace_back("others");
  }

 private:
  std::size_t index_;
  std::vector<std::string>& log_;
};

TEST(Senses, of_all_nodes_follow_what_each_measures_a_share_of) {
  const scene::SceneDesc scene = stage::testing::crowd(5, stage::testing::Sensing::kSonar);
  world::World world(scene, 1);
  for (const world::RangerRow row : world.rangers.rows()) world::subscribe(world, world.rangers.model[row]);
  bodies::Trees trees = bodies::make_trees(world);
  const bodies::Solids solids = stage::testing::make_solids(world, trees);
  const bodies::Walls walls(solids);
  const bodies::DiscIndex index;
  world::Workers workers(1);
  const bodies::Space space{solids, index, walls};
  const auto measured_by = [&](world::Division* division, std::vector<std::string>& log) {
    Senses senses;
    using behaviour::Sharing;
    for (const auto& [sharing, name] :
         {std::pair(Sharing::kAll, "all"), {Sharing::kRows, "rows"}, {Sharing::kHead, "head"}})
      senses.add(std::make_unique<Counting>(sharing, log, name));
    senses.populate(world, space);
    senses.sense(world, space, 1, workers, division);
    return log;
  };
  std::vector<std::string> alone, first, second;
  HalfOfTheWork head(0, first), node(1, second);
  EXPECT_EQ(measured_by(nullptr, alone), (std::vector<std::string>{"rows5", "head5", "all5"}));
  EXPECT_EQ(measured_by(&head, first), (std::vector<std::string>{"rows2", "head5", "others", "all5"}));
  EXPECT_EQ(measured_by(&node, second), (std::vector<std::string>{"rows3", "others", "all5"}));
}

TEST(RangerKinds, keep_what_rangers_that_are_alike_share) {
  const scene::SceneDesc few = stage::testing::crowd(3, stage::testing::Sensing::kSonar),
                         lasers = stage::testing::crowd(2, stage::testing::Sensing::kLaser),
                         many = stage::testing::crowd(9, stage::testing::Sensing::kSonar);
  rays::RangerKinds kinds;
  kinds.populate(world::World(few, 1), std::vector{0.3});
  const std::uint16_t* const table = kinds.kinds.at(0).bundles.at(0).tables.at(0).meets.data();
  kinds.populate(world::World(lasers, 1), std::vector{0.2});
  EXPECT_EQ(kinds.of_ranger, (std::vector<std::uint32_t>{1, 1}));
  kinds.populate(world::World(many, 1), std::vector{0.3});
  EXPECT_EQ(kinds.kinds.size(), 2u);
  EXPECT_EQ(kinds.of_ranger, std::vector<std::uint32_t>(9, 0));
  EXPECT_EQ(kinds.kinds[0].bundles[0].tables[0].meets.data(), table);
  const double half = kinds.kinds[0].bundles[0].tables[0].half;
  kinds.populate(world::World(many, 1), std::vector{0.5, 0., 40.});
  const std::vector<rays::Bundle::Table>& tables = kinds.kinds[0].bundles[0].tables;
  ASSERT_EQ(tables.size(), 3u);
  EXPECT_GE(tables[0].half, half + 0.2) << "tables are good for larger bodies";
  EXPECT_GE(tables[2].half, half + 39.7);
  kinds.populate(world::World(many, 1), std::vector{0.1});
  EXPECT_LT(tables[0].half, half) << "much smaller ones have a table of their own";
}

}  // namespace
}  // namespace playhouse::senses
