// Requests for steps: what a client is told, and what is left of it. Out of scope here: what steps do
// (simulation_test.cc, lock_step_test.cc), and models that come and go (tests/e2e).

#include "playhouse/bridge/simulated/world_requests.h"

#include <gtest/gtest.h>

#include <cstring>
#include <memory>
#include <string>
#include <vector>

#include "playhouse/base/limits.h"
#include "playhouse/bridge/testing/still_devices.h"
#include "playhouse/wire/codec.h"
#include "playhouse/world/population/population.h"

namespace playhouse::drivers {
namespace {

namespace sim = wire::simulation;

/// A world, in lock-step or not, and a client of it.
class WorldRequests : public ::testing::Test {
 protected:
  void open(std::optional<run::LockStep::LockStepOptions> lock_step) {
    simulation_ = std::make_unique<run::Simulation>(
        std::make_unique<run::testing::StillEngine>(scene_),
        run::Simulation::SimulationOptions{.speed = 0, .duration = 0, .lock_step = std::move(lock_step)});
  }
  /// The value of a NACK; empty where there is none yet, or an ACK.
  std::string ask(const std::string& property, const std::string& value) {
    device::Replier replier(recorder_, ++ticket_);
    const sim::PropertyReq request{wire::c_string("world"), wire::c_string(property), 0, value};
    EXPECT_TRUE(ask_for_world(*simulation_, request, &client_, replier, overlaps_));
    const auto answer = recorder_.answers.find(ticket_);
    if (answer == recorder_.answers.end() || answer->second.ack) return {};
    return std::string(wire::text(wire::decode<sim::PropertyReq>(answer->second.body)->value));
  }
  std::string step(std::uint32_t ticks) {
    return ask("step", std::string(reinterpret_cast<const char*>(&ticks), sizeof ticks));
  }

  const scene::SceneDesc scene_ = run::testing::scene_of("interval_sim 100\nposition( name \"r0\" )\n");
  testing::OutputRecorder recorder_;
  device::Caller client_{"somebody"};
  OverlapWarnings overlaps_;
  std::unique_ptr<run::Simulation> simulation_;
  std::uint64_t ticket_ = 0;
};

TEST_F(WorldRequests, for_steps_tell_how_many_there_may_be) {
  open({});
  EXPECT_EQ(step(1001), "invalid number of ticks: 1 to 1000 is valid, in 4 or 8 bytes");
  EXPECT_FALSE(simulation_->requests().pace().paused) << "it was refused";
  open(run::LockStep::LockStepOptions{});
  EXPECT_EQ(step((1u << 20) + 1), "invalid number of ticks: 1 to 1048576 is valid, in 4 or 8 bytes");
}

TEST_F(WorldRequests, for_steps_of_a_running_world_are_refused_and_a_paused_one_stays_paused) {
  open({});
  EXPECT_EQ(step(5), "the world is running: pause it first, or start it with --lock-step");
  EXPECT_FALSE(simulation_->requests().pace().paused);
  simulation_->requests().pause();
  EXPECT_EQ(step(5), "");
  EXPECT_FALSE(recorder_.answers.contains(ticket_)) << "the steps are not done yet";
  simulation_->extend(5);
  simulation_->run();
  EXPECT_TRUE(recorder_.answers.at(ticket_).ack);
  EXPECT_EQ(simulation_->world().tick(), 5u);
  EXPECT_TRUE(simulation_->requests().pace().paused);
}

TEST_F(WorldRequests, for_spawns_far_from_everything_are_refused) {
  open({});
  std::string place(24, '\0');
  const double x = 900e3;
  std::memcpy(place.data(), &x, sizeof x);
  device::Replier replier(recorder_, ++ticket_);
  const sim::PropertyReq request{wire::c_string("r0"), wire::c_string("spawn"), 0, place};
  ASSERT_TRUE(ask_for_world(*simulation_, request, &client_, replier, overlaps_));
  simulation_->extend(1);
  simulation_->run();
  EXPECT_FALSE(recorder_.answers.at(ticket_).ack);
  const Result<sim::PropertyReq> told = wire::decode<sim::PropertyReq>(recorder_.answers.at(ticket_).body);
  EXPECT_EQ(wire::text(told->value), "900000.00 0.00 is more than 1000 m from everything in the world");
  EXPECT_EQ(simulation_->world().models.size(), 1u);
}

TEST_F(WorldRequests, for_spawns_are_refused_once_the_run_is_full) {
  open({});
  world::World& world = simulation_->engine().world();
  for (std::size_t i = 0; i < limits::kBroughtModels; ++i)
    ASSERT_TRUE(world::spawn(world, 0, {}, "n" + std::to_string(i)));
  device::Replier replier(recorder_, ++ticket_);
  const sim::PropertyReq request{wire::c_string("r0"), wire::c_string("spawn"), 0, std::string(24, '\0')};
  ASSERT_TRUE(ask_for_world(*simulation_, request, &client_, replier, overlaps_));
  simulation_->extend(1);
  simulation_->run();
  ASSERT_TRUE(recorder_.answers.contains(ticket_));
  EXPECT_FALSE(recorder_.answers[ticket_].ack);
  const Result<sim::PropertyReq> told = wire::decode<sim::PropertyReq>(recorder_.answers[ticket_].body);
  EXPECT_EQ(wire::text(told->value), "the run is full: 16384 models with 0 sensors and 0 beams came");
}

TEST_F(WorldRequests, for_spawns_are_refused_once_the_share_of_a_client_is_full) {
  open({});
  world::World& world = simulation_->engine().world();
  device::Caller other{"another"};
  std::vector<world::ModelId> brought;
  for (std::size_t i = 0; i < limits::kBroughtByOneModels; ++i) {
    const Result<world::ModelId> came = world::spawn(world, 0, {}, "n" + std::to_string(i));
    ASSERT_TRUE(came);
    simulation_->shares()->add(world, client_.holder(), *came);
    brought.push_back(*came);
  }
  const auto spawned_for = [&](device::Caller& client) {
    device::Replier replier(recorder_, ++ticket_);
    const sim::PropertyReq request{wire::c_string("r0"), wire::c_string("spawn"), 0, std::string(24, '\0')};
    EXPECT_TRUE(ask_for_world(*simulation_, request, &client, replier, overlaps_));
    simulation_->extend(1);
    simulation_->run();
    return recorder_.answers.at(ticket_).ack;
  };
  EXPECT_FALSE(spawned_for(client_));
  EXPECT_EQ(wire::text(wire::decode<sim::PropertyReq>(recorder_.answers[ticket_].body)->value),
            "your share of the run is full: you brought 4096 models with 0 sensors and 0 beams");
  EXPECT_TRUE(spawned_for(other)) << "who has a share of its own";
  ASSERT_TRUE(world::despawn(world, brought[5]));
  EXPECT_TRUE(spawned_for(client_));
  EXPECT_FALSE(spawned_for(client_)) << "what it spawned counts";
}

TEST_F(WorldRequests, that_are_refused_leave_nothing_with_the_client) {
  open(run::LockStep::LockStepOptions{.members = 1, .names = {"left"}});
  for (int k = 0; k < 100; ++k) {
    EXPECT_EQ(step(1), "clients of this world join by name first");
    EXPECT_NE(ask("join", wire::c_string("nobody")), "");
  }
  EXPECT_EQ(client_.task_count(), 0u);
}

TEST_F(WorldRequests, of_a_member_have_it_leave_once_however_many_there_were) {
  open(run::LockStep::LockStepOptions{.members = 1, .names = {"left"}});
  for (int k = 0; k < 100; ++k) {
    EXPECT_EQ(ask("join", wire::c_string("left")), "");
    step(1);
    simulation_->lock_step()->leave(&client_);  // as one that was silent
  }
  EXPECT_EQ(client_.task_count(), 1u);
  EXPECT_EQ(ask("join", wire::c_string("left")), "");
  client_.leave();
  EXPECT_FALSE(simulation_->lock_step()->has(&client_));
}

}  // namespace
}  // namespace playhouse::drivers
