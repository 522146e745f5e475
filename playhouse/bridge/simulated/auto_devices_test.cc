// Automatic devices of models that come and go: which addresses they get, and that nothing is left of them.
// Out of scope here: what clients hear (app/population_test.cc).

#include "playhouse/bridge/simulated/auto_devices.h"
#include "playhouse/bridge/simulated/simulated_world.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "playhouse/bridge/testing/memory_site.h"
#include "playhouse/wire/generated/position2d.h"
#include "playhouse/wire/generated/simulation.h"
#include "playhouse/world/population/population.h"
#include "playhouse/world/saving/state.h"

namespace playhouse::drivers {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using testing::MemorySite;
using world::ModelId;
namespace p2d = wire::position2d;

constexpr std::uint8_t kCmd = 2, kReq = 3;

// By rows: 0 robot "a" with a laser (1); 2 robot "two" with two lasers (3, 4); 5 a laser that no robot
// carries.
constexpr const char* kWorld = R"(
interval_sim 100
define laser ranger( sensor( samples 3 fov 180 ) )
position( name "a" laser( name "l" ) )
position( name "two" laser( name "l" ) laser( name "m" ) )
laser( name "gate" )
)";
constexpr std::uint32_t kA = 0, kTwo = 2, kGate = 5;

class AutoDevicesTest : public ::testing::Test {
 protected:
  AutoDevicesTest() : site(kWorld) {
    EXPECT_TRUE(site.site().open_world("some.world"));
    robots = std::make_unique<AutoDevices>(site.site(), 6665);
    EXPECT_TRUE(robots->add_all());
  }
  run::Simulation& simulation() { return *simulation_of(site.site()); }
  void post(std::function<void(world::Journal&)> change) {
    EXPECT_TRUE(simulation().requests().post(std::move(change)));
  }
  /// Comes before the next tick, and its devices with it.
  ModelId come(std::uint32_t prototype) {
    ModelId id;
    post([&](world::Journal& journal) { id = *journal.spawn(prototype, {}); });
    site.run(0);
    return id;
  }
  void go(ModelId id) {
    post([=](world::Journal& journal) { EXPECT_TRUE(journal.despawn(id)); });
    site.run(0);
  }
  std::vector<std::string> names(ModelId id) {
    return device_names(model_devices_of(site.site())->directory(), id, 6665);
  }
  std::size_t devices() { return site.site().device_count(); }

  MemorySite site;
  std::unique_ptr<AutoDevices> robots;
};

TEST_F(AutoDevicesTest, of_a_robot_that_comes_have_numbers_that_nobody_had) {
  EXPECT_THAT(names({kTwo}), ElementsAre("position2d:1", "position3d:1", "speech:1", "speech_recognition:1"));
  EXPECT_THAT(names({kGate}), ElementsAre("ranger:3", "laser:3"));
  const ModelId first = come(kA);
  EXPECT_THAT(names(first), ElementsAre("position2d:4", "position3d:4", "speech:4", "speech_recognition:4"))
      << "laser:2 and laser:3 are taken";
  EXPECT_THAT(names({first.value + 1}), ElementsAre("ranger:4", "laser:4"));
  const ModelId second = come(kTwo);
  EXPECT_THAT(names(second), ElementsAre("position2d:5", "position3d:5", "speech:5", "speech_recognition:5"));
  EXPECT_THAT(names({second.value + 1}), ElementsAre("ranger:5", "laser:5"));
  EXPECT_THAT(names({second.value + 2}), ElementsAre("ranger:6", "laser:6"));
  EXPECT_THAT(names(come(kGate)), ElementsAre("ranger:7", "laser:7"));
  EXPECT_TRUE(site.site().find({6665, p2d::kCode, 5}).has_value());
}

TEST_F(AutoDevicesTest, go_with_their_robot_and_leave_their_numbers_to_nobody) {
  const std::size_t before = devices();
  const ModelId first = come(kA);
  EXPECT_EQ(devices(), before + 6);
  go(first);
  EXPECT_EQ(devices(), before);
  EXPECT_THAT(names(first), IsEmpty());
  EXPECT_EQ(site.retired.size(), 6u);
  EXPECT_THAT(names(come(kA)),
              ElementsAre("position2d:5", "position3d:5", "speech:5", "speech_recognition:5"));
  go({kA});
  EXPECT_FALSE(site.site().find({6665, p2d::kCode, 0}).has_value()) << "one of the start";
}

TEST_F(AutoDevicesTest, are_decided_change_by_change_however_many_wait_for_a_tick) {
  ModelId gone, stays;
  post([&](world::Journal& journal) { gone = *journal.spawn(kA, {}); });
  post([&](world::Journal& journal) { EXPECT_TRUE(journal.despawn(gone)); });
  post([&](world::Journal& journal) { stays = *journal.spawn(kA, {}); });
  site.run(0);
  EXPECT_THAT(names(stays), ElementsAre("position2d:5", "position3d:5", "speech:5", "speech_recognition:5"));
  EXPECT_EQ(site.retired.size(), 6u) << "those of the first, which clients may have seen";
}

TEST_F(AutoDevicesTest, are_none_of_what_goes_in_the_very_change_in_which_it_came) {
  post([&](world::Journal& journal) { EXPECT_TRUE(journal.despawn(*journal.spawn(kA, {}))); });
  site.run(0);
  EXPECT_THAT(site.retired, IsEmpty());
  EXPECT_THAT(names(come(kA)),
              ElementsAre("position2d:4", "position3d:4", "speech:4", "speech_recognition:4"));
}

TEST_F(AutoDevicesTest, are_known_to_listeners_with_the_world_that_they_are_in) {
  std::vector<std::size_t> seen;
  simulation().follow(run::on_show([&](const world::World& world, const world::Pace&) {
    const ModelId newest = world.models.id.back();
    if (newest.value > kGate) seen.push_back(names(newest).size());
  }));
  come(kA);
  go({6});
  EXPECT_THAT(seen, ElementsAre(2u));
}

TEST_F(AutoDevicesTest, follow_what_a_tick_changes) {
  world::World& world = simulation().engine().world();
  const ModelId id = *world::spawn(world, kA, {});  // as a phase of the engine may
  site.run(1);
  EXPECT_THAT(names(id), ElementsAre("position2d:4", "position3d:4", "speech:4", "speech_recognition:4"));
}

TEST_F(AutoDevicesTest, measure_and_obey_as_others_do_until_their_robot_goes) {
  const ModelId robot = come(kA);
  const device::DeviceId wheels = site.id({6665, p2d::kCode, 4}), laser = site.id({6665, 6, 4});
  ASSERT_TRUE(site.hold(wheels));
  ASSERT_TRUE(site.hold(laser));
  site.run(1);
  EXPECT_EQ(site.recorder.published.size(), 2u);
  EXPECT_EQ(model_devices_of(site.site())->sources().size(), 2u);
  device::Driver& driver = site.driver({6665, p2d::kCode, 4});
  const std::vector<std::byte> go_on = wire::encode(p2d::CmdVel{{0.3, 0, 0}, 1});
  EXPECT_EQ(driver.command({wheels, kCmd, p2d::kCmdVel, go_on}), device::Taken::kLatest);

  // A request and a command are under way when the robot goes.
  post([=](world::Journal& journal) { EXPECT_TRUE(journal.despawn(robot)); });
  const std::vector<std::byte> power = wire::encode(p2d::PowerConfig{0});
  driver.request({wheels, kReq, p2d::kReqMotorPower, power}, device::Replier(site.recorder, 1));
  driver.command({wheels, kCmd, p2d::kCmdVel, go_on});
  site.run(1);
  EXPECT_FALSE(site.recorder.answers.at(1).ack);
  EXPECT_EQ(site.recorder.published.size(), 2u);
  site.run(0);  // the stops have reached the tick
  EXPECT_EQ(model_devices_of(site.site())->sources().size(), 0u);
  EXPECT_EQ(robots->driver().device_count(), devices());
  // A driver that has not heard yet.
  EXPECT_EQ(driver.command({wheels, kCmd, p2d::kCmdVel, go_on}), device::Taken::kNo);
  driver.request({wheels, kReq, p2d::kReqGetGeom, {}}, device::Replier(site.recorder, 2));
  EXPECT_FALSE(site.recorder.answers.at(2).ack);
  EXPECT_FALSE(driver.capable(wheels, kCmd, p2d::kCmdVel));
}

TEST_F(AutoDevicesTest, opened_while_their_robot_goes_end_as_all_do) {
  const ModelId robot = come(kA);
  const device::DeviceId wheels = site.id({6665, p2d::kCode, 4});
  post([=](world::Journal& journal) { EXPECT_TRUE(journal.despawn(robot)); });
  ASSERT_TRUE(site.hold(wheels)) << "clients have not heard yet";
  site.run(1);
  EXPECT_FALSE(site.hold(wheels));
  site.run(0);
  EXPECT_EQ(model_devices_of(site.site())->sources().size(), 0u);
}

TEST_F(AutoDevicesTest, stay_when_the_run_is_taken_back_and_those_of_whom_came_since_retire) {
  const std::size_t before = devices();
  simulation().requests().record(true);
  site.run(1);
  const std::uint64_t instant = simulation().requests().timeline()->ticks.front();
  const world::ModelId robot = come(kA);
  ASSERT_TRUE(site.hold(site.id({6665, p2d::kCode, 0})));
  ASSERT_TRUE(site.hold(site.id({6665, p2d::kCode, 4})));
  site.run(10);
  run::testing::rewind_to(simulation(), instant);
  site.hear();
  EXPECT_EQ(simulation().world().tick(), instant);
  EXPECT_EQ(devices(), before);
  EXPECT_THAT(names(robot), IsEmpty());
  EXPECT_THAT(names({kA}), ElementsAre("position2d:0", "position3d:0", "speech:0", "speech_recognition:0"));
  EXPECT_EQ(site.held[site.id({6665, p2d::kCode, 0}).row].size(), 1u) << "who has it open goes on";
  site.run(0);
  EXPECT_EQ(model_devices_of(site.site())->sources().size(), 1u);
  EXPECT_THAT(names(come(kA)),
              ElementsAre("position2d:5", "position3d:5", "speech:5", "speech_recognition:5"))
      << "and numbers are used once";
}

TEST_F(AutoDevicesTest, of_robots_that_come_back_have_their_addresses_again) {
  const world::ModelId robot = come(kA);
  simulation().requests().record(true);
  site.run(1);
  const std::uint64_t instant = simulation().requests().timeline()->ticks.front();
  ASSERT_TRUE(site.hold(site.id({6665, p2d::kCode, 4})));
  ASSERT_TRUE(site.hold(site.id({6665, p2d::kCode, 0})));
  go(robot);
  go({kA});
  site.run(10);
  run::testing::rewind_to(simulation(), instant);
  site.hear();
  EXPECT_THAT(names(robot), ElementsAre("position2d:4", "position3d:4", "speech:4", "speech_recognition:4"));
  EXPECT_THAT(names({kA}), ElementsAre("position2d:0", "position3d:0", "speech:0", "speech_recognition:0"));
  const device::DeviceId wheels = site.id({6665, p2d::kCode, 4});
  ASSERT_TRUE(site.hold(wheels));
  site.run(1);
  EXPECT_EQ(site.recorder.published.back().device, wheels);
}

TEST_F(AutoDevicesTest, that_close_late_take_no_use_from_a_robot_that_came_back) {
  const world::ModelId robot = come(kA);
  const device::DeviceId wheels = site.id({6665, p2d::kCode, 4});
  simulation().requests().record(true);
  site.run(1);
  ASSERT_TRUE(site.hold(wheels));
  site.run(10);
  const std::uint64_t instant = simulation().requests().timeline()->ticks.back();
  ASSERT_GE(instant, 10u);
  // It goes and comes back, and only then the io thread hears of it.
  ASSERT_TRUE(
      simulation().requests().post([=](world::Journal& journal) { EXPECT_TRUE(journal.despawn(robot)); }));
  run::testing::rewind_to(simulation(), instant);
  world::World& world = simulation().engine().world();
  ASSERT_TRUE(world.row(robot));
  world::subscribe(world, world.row(robot));
  site.run(0);  // retires, closes
  site.run(0);
  EXPECT_EQ(world.models.subscribers[world.row(robot)], 1u);
}

TEST_F(AutoDevicesTest, are_those_of_the_newest_that_has_an_id_which_a_tick_gave_again) {
  const auto comes_in_a_tick = [&] {
    const ModelId id = *world::spawn(simulation().engine().world(), kA, {});
    site.run(1);
    return id;
  };
  simulation().requests().record(true);
  site.run(1);
  const std::uint64_t instant = simulation().requests().timeline()->ticks.front();
  const ModelId first = comes_in_a_tick();
  run::testing::rewind_to(simulation(), instant);
  site.hear();
  ASSERT_EQ(comes_in_a_tick(), first);
  EXPECT_EQ(names(first).front(), "position2d:5");
  site.run(10);
  const std::uint64_t later = simulation().requests().timeline()->ticks.back();
  go(first);
  run::testing::rewind_to(simulation(), later);
  site.hear();
  EXPECT_THAT(names(first), ElementsAre("position2d:5", "position3d:5", "speech:5", "speech_recognition:5"));
}

/// Robots whose numbers are used up: an interface has few indices.
class ManyRobots : public ::testing::Test {
 protected:
  explicit ManyRobots(std::size_t indices = 256) : indices_(indices), site(kFewThings) {
    EXPECT_TRUE(site.site().open_world("some.world"));
    site.last_port = 6665;
    robots = std::make_unique<AutoDevices>(site.site(), 6665, indices);
    EXPECT_TRUE(robots->add_all());
  }
  static constexpr const char* kFewThings =
      "interval_sim 1000\ndefine laser ranger( sensor( samples 3 fov 180 ) )\n"
      "position( name \"a\" laser( name \"l\" ) )\nposition( name \"b\" )\nlaser( name \"gate\" )\n";
  static constexpr std::uint32_t kA = 0, kB = 2, kGate = 3;

  run::Simulation& simulation() { return *simulation_of(site.site()); }
  std::vector<ModelId> come(std::size_t count, std::uint32_t prototype = kA) {
    std::vector<ModelId> ids;
    EXPECT_TRUE(simulation().requests().post([&](world::Journal& journal) {
      for (std::size_t k = 0; k < count; ++k)
        ids.push_back(*journal.spawn(prototype, {}, std::to_string(++named_)));
    }));
    site.run(0);
    return ids;
  }
  void go(const std::vector<ModelId>& ids) {
    EXPECT_TRUE(simulation().requests().post([=](world::Journal& journal) {
      for (const ModelId id : ids) EXPECT_TRUE(journal.despawn(id));
    }));
    site.run(0);
    site.retired.clear();
  }
  /// Until there is no number that nobody had; a tick for each that comes and goes, or none.
  void use_up(int ticks) {
    while (named_ + 3 < indices_) {
      go(come(1));
      site.run(ticks);
    }
  }
  void rest() { site.run(static_cast<int>(RetiredIndices::kRest)); }
  std::vector<std::string> names(ModelId id) {
    return device_names(model_devices_of(site.site())->directory(), id, 6665);
  }
  std::string wheels(ModelId id) { return names(id).empty() ? "" : names(id).front(); }

  const std::size_t indices_;
  std::size_t named_ = 0;
  MemorySite site;
  std::unique_ptr<AutoDevices> robots;
};

TEST_F(ManyRobots, have_the_numbers_that_have_been_free_the_longest) {
  const std::vector<ModelId> stay = come(3);
  go({stay[1]});
  site.run(1);
  go({stay[0]});
  use_up(1);
  const std::vector<ModelId> next = come(3);
  EXPECT_EQ(wheels(next[0]), "position2d:4") << "of the first that went";
  EXPECT_THAT(names({next[0].value + 1}), Contains("laser:4"));
  EXPECT_EQ(wheels(next[1]), "position2d:3");
  EXPECT_EQ(wheels(next[2]), "position2d:6");
  EXPECT_EQ(wheels(stay[2]), "position2d:5");
  EXPECT_EQ(robots->left_out(), 0u);
}

TEST_F(ManyRobots, have_no_devices_while_every_number_is_taken_or_rests) {
  use_up(0);
  const ModelId early = come(1).front();
  EXPECT_EQ(wheels(early), "");
  EXPECT_EQ(robots->left_out(), 5u)
      << "wheels, position3d, speech, speech_recognition and laser; its ranger has one that nobody had";
  rest();
  EXPECT_EQ(wheels(come(1).front()), "position2d:3");
  EXPECT_EQ(wheels(early), "") << "who had none gets none later";
}

// A number is one for wheels, speech, laser, sonar and power.
TEST_F(ManyRobots, have_a_number_once_nobody_has_it_in_any_interface) {
  ASSERT_THAT(names({kGate}), Contains("laser:2"));
  use_up(0);
  rest();
  const std::vector<ModelId> all = come(indices_ - 3, kB);
  EXPECT_EQ(robots->left_out(), 0u);
  for (const ModelId robot : all) EXPECT_NE(wheels(robot), "position2d:2") << "the gate's laser has it";
  go({ModelId{kGate}});
  rest();
  EXPECT_EQ(wheels(come(1, kB).front()), "position2d:2");
}

TEST_F(ManyRobots, that_come_back_have_numbers_that_others_had_in_their_place) {
  simulation().requests().record(true);
  const ModelId first = come(1).front();
  ASSERT_EQ(wheels(first), "position2d:3");
  site.run(1);
  const std::uint64_t instant = simulation().requests().timeline()->ticks.back();
  go({first});
  use_up(1);
  rest();
  const ModelId heir = come(1).front();
  ASSERT_EQ(wheels(heir), "position2d:3");
  ASSERT_LE(simulation().requests().timeline()->ticks.front(), instant)
      << "the history is too short for this test";
  run::testing::rewind_to(simulation(), instant);
  site.hear();
  EXPECT_EQ(wheels(first), "position2d:3");
  EXPECT_EQ(wheels(heir), "");
  const device::DeviceId id = site.id({6665, p2d::kCode, 3});
  ASSERT_TRUE(site.hold(id));
  site.run(1);
  EXPECT_EQ(site.recorder.published.back().device, id);
  rest();
  while (wheels(come(1).front()) != "")
    EXPECT_NE(wheels(simulation().world().models.id.back()), "position2d:3");
}

/// With further ports.
class RobotsOfSeveralPorts : public ManyRobots {
 protected:
  RobotsOfSeveralPorts() : ManyRobots(4) { site.last_port = 6667; }
  bool has_world(std::uint32_t port) {
    return site.site().find({port, wire::simulation::kCode, 0}).has_value();
  }
};

// Robots 0 and 1 and the gate's laser:2 are there from the start.
TEST_F(RobotsOfSeveralPorts, continue_on_the_next_port_which_is_opened_then) {
  EXPECT_EQ(wheels(come(1).front()), "position2d:3");
  EXPECT_THAT(site.ports, IsEmpty());
  const std::vector<ModelId> next = come(5);
  EXPECT_THAT(site.ports, ElementsAre(6666u, 6667u));
  EXPECT_EQ(wheels(next[0]), "6666:position2d:0");
  EXPECT_THAT(names({next[0].value + 1}), ElementsAre("ranger:3", "6666:laser:0"))
      << "each counts for itself";
  EXPECT_EQ(wheels(next[3]), "6666:position2d:3");
  EXPECT_EQ(wheels(next[4]), "6667:position2d:0");
  EXPECT_TRUE(has_world(6665) && has_world(6666) && has_world(6667));
  ASSERT_TRUE(site.hold(site.id({6667, p2d::kCode, 0})));
  site.run(1);
  EXPECT_EQ(site.recorder.published.back().device, site.id({6667, p2d::kCode, 0}));
}

TEST_F(RobotsOfSeveralPorts, are_told_to_clients_with_their_port_if_it_is_another_one) {
  const std::vector<ModelId> ids = come(2);
  const std::string name(simulation().world().name(simulation().world().row(ids[1])));
  const auto told = [&](std::uint32_t port) {
    const device::Address address{port, wire::simulation::kCode, 0};
    const std::uint8_t get = wire::simulation::kReqGetProperty;
    const std::vector<std::byte> asked =
        wire::encode(wire::simulation::PropertyReq{wire::c_string(name), wire::c_string("devices"), 0, {}});
    site.driver(address).request({site.id(address), kReq, get, asked}, device::Replier(site.recorder, port));
    site.run(0);
    const auto answer = wire::decode<wire::simulation::PropertyReq>(site.recorder.answers.at(port).body);
    return std::string(wire::text(answer->value));
  };
  EXPECT_EQ(
      told(6665),
      "6666:position2d:0 6666:position3d:0 6666:speech:0 6666:speech_recognition:0 ranger:3 6666:laser:0");
  EXPECT_EQ(told(6666), "position2d:0 position3d:0 speech:0 speech_recognition:0 6665:ranger:3 laser:0");
}

TEST_F(RobotsOfSeveralPorts, have_none_once_a_port_is_in_use) {
  const std::vector<ModelId> ids = come(20);
  EXPECT_THAT(site.ports, ElementsAre(6666u, 6667u));
  EXPECT_EQ(wheels(ids[8]), "6667:position2d:3");
  EXPECT_EQ(wheels(ids[9]), "");
  site.last_port = 65535;
  EXPECT_EQ(wheels(come(1).front()), "") << "its line was the last word";
  EXPECT_FALSE(has_world(6668));
  go({ids[7]});
  rest();
  EXPECT_EQ(wheels(come(1).front()), "6667:position2d:2") << "free again";
}

TEST_F(RobotsOfSeveralPorts, have_a_rested_number_before_a_new_port) {
  const std::vector<ModelId> ids = come(5);
  ASSERT_EQ(wheels(ids[4]), "6666:position2d:3");
  go({ids[0], ids[2]});
  rest();
  EXPECT_EQ(wheels(come(1).front()), "position2d:3");
  EXPECT_EQ(wheels(come(1).front()), "6666:position2d:1");
  EXPECT_THAT(site.ports, ElementsAre(6666u));
  EXPECT_EQ(wheels(come(1).front()), "6667:position2d:0");
}

// Robots 0 and 1 and the gate stay.
TEST_F(RobotsOfSeveralPorts, open_no_third_port_if_few_come_and_go_without_a_rest) {
  std::size_t without = 0;
  for (int k = 0; k < 100; ++k) {
    const std::vector<ModelId> id = come(1);
    without += wheels(id[0]).empty();
    go(id);
  }
  EXPECT_THAT(site.ports, ElementsAre(6666u));
  EXPECT_EQ(without, 100u - 5u) << "numbers 3 to 7";
  rest();
  const std::vector<ModelId> stay = come(9);
  EXPECT_THAT(site.ports, ElementsAre(6666u, 6667u)) << "who stay need it";
  EXPECT_EQ(wheels(stay[0]), "position2d:3") << "rested";
  EXPECT_EQ(wheels(stay[4]), "6666:position2d:3");
  EXPECT_EQ(wheels(stay[8]), "6667:position2d:3");
}

TEST_F(RobotsOfSeveralPorts, come_back_on_their_port) {
  const std::vector<ModelId> ids = come(3);
  ASSERT_EQ(wheels(ids[2]), "6666:position2d:1");
  simulation().requests().record(true);
  site.run(1);
  const std::uint64_t instant = simulation().requests().timeline()->ticks.back();
  go({ids[2]});
  const ModelId later = come(1).front();
  ASSERT_EQ(wheels(later), "6666:position2d:2");
  site.run(2);
  run::testing::rewind_to(simulation(), instant);
  site.hear();
  EXPECT_EQ(wheels(ids[2]), "6666:position2d:1");
  EXPECT_EQ(wheels(later), "");
  EXPECT_TRUE(has_world(6666));
  EXPECT_EQ(wheels(come(1).front()), "6666:position2d:3") << "and numbers are used once";
}

class VeryManyRobots : public ManyRobots {
 protected:
  VeryManyRobots() : ManyRobots(2000) {}  // three times as many as rest at a time
};

TEST_F(VeryManyRobots, have_devices_however_many_came_and_went_before) {
  constexpr std::size_t kAtOnce = 10;
  std::size_t came = 0, without = 0;
  std::map<std::string, std::size_t> had;
  for (; came < 5000; came += kAtOnce) {
    const std::vector<ModelId> ids = come(kAtOnce, kB);
    for (const ModelId id : ids) {
      without += names(id).empty();
      ++had[wheels(id)];
    }
    go(ids);
    site.run(1);
  }
  EXPECT_EQ(without, 0u);
  EXPECT_EQ(robots->left_out(), 0u);
  EXPECT_EQ(had.size(), indices_ - 3) << "all but those that are taken all the time";
  for (const auto& [name, times] : had) EXPECT_LE(times, 3u) << name;
  EXPECT_EQ(site.site().device_count(), 13u);
}

}  // namespace
}  // namespace playhouse::drivers
