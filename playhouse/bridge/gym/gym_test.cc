// Agents and their link: that what a learning program asks for is done, or told not to be. Out of scope here:
// the columns and episodes (clients/python/tests/test_gym.py).

#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <memory>
#include <span>
#include <string>
#include <thread>
#include <vector>

#include "playhouse/bridge/gym/link.h"
#include "playhouse/bridge/gym/shared_columns.h"
#include "playhouse/run/testing/still_engine.h"
#include "playhouse/world/population/population.h"

namespace playhouse::drivers::gym {
namespace {

constexpr const char* kWorld = R"(
interval_sim 100
define laser ranger( sensor( samples 3 fov 180 ) )
position( name "a" laser() )
position( name "b" pose [2 0 0 0] laser() )
)";
constexpr world::ModelId kB{2}, kLaserOfB{3};

/// A world in lock-step.
class Gym : public ::testing::Test {
 protected:
  explicit Gym(double duration = 0)
      : simulation_(std::make_unique<run::testing::StillEngine>(scene_),
                    {.speed = 0, .duration = duration, .lock_step = run::LockStep::LockStepOptions{}}) {}
  void carry_out(std::function<void(world::Journal&)> change) {
    ASSERT_TRUE(simulation_.requests().post(std::move(change)));
    simulation_.run();
  }
  world::World& world() { return simulation_.engine().world(); }
  std::uint32_t subscribers(world::ModelId model) { return world().models.subscribers[world().row(model)]; }

  const scene::SceneDesc scene_ = run::testing::scene_of(kWorld);
  run::Simulation simulation_;
};

TEST(SharedColumnsOfGym, keep_their_size_whatever_the_other_program_does) {
  SharedColumns columns;
  const SharedColumns::ColumnFormat column{"ranges", "<f4", 100, 3, 4};
  ASSERT_TRUE(columns.make(std::span(&column, 1)));
  struct stat before {};
  ASSERT_EQ(fstat(columns.descriptor(), &before), 0);
  EXPECT_NE(ftruncate(columns.descriptor(), 10), 0);
  EXPECT_EQ(errno, EPERM);
  EXPECT_NE(ftruncate(columns.descriptor(), before.st_size + 4096), 0);
  struct stat after {};
  ASSERT_EQ(fstat(columns.descriptor(), &after), 0);
  EXPECT_EQ(after.st_size, before.st_size);
}

TEST_F(Gym, an_agent_that_comes_back_with_the_start_is_used_again) {
  Agents agents(simulation_);
  ASSERT_TRUE(agents.begin());
  simulation_.run();
  EXPECT_EQ(subscribers(kB), 1u);
  carry_out([](world::Journal& journal) { EXPECT_TRUE(journal.despawn(kB)); });
  for (int time = 0; time < 2; ++time) {
    carry_out([&](world::Journal& journal) {
      ASSERT_TRUE(simulation_.restart(7));
      agents.reset_all(journal);
    });
    EXPECT_EQ(subscribers(kB), 1u);
    EXPECT_EQ(subscribers(kLaserOfB), 1u);
    EXPECT_EQ(subscribers({0}), 1u);
  }
}

/// The other end of a link, and the run, which ends with it.
class LinkedGym : public Gym {
 protected:
  LinkedGym() : Gym(1e6) {
    int ends[2] = {-1, -1};
    EXPECT_EQ(socketpair(AF_UNIX, SOCK_STREAM, 0, ends), 0);
    program_ = ends[0];
    link_ = std::make_unique<Link>(simulation_, ends[1]);
    EXPECT_TRUE(link_->start());
    EXPECT_EQ(answer(), "");
    ticks_ = std::thread([this] { simulation_.run(); });
  }
  ~LinkedGym() override {
    close(program_);
    ticks_.join();
  }
  void ask(std::uint32_t verb, std::uint32_t ticks, std::uint64_t seed) {
    struct {
      std::uint32_t verb, ticks;
      std::uint64_t seed;
    } const request{verb, ticks, seed};
    ASSERT_EQ(send(program_, &request, sizeof request, MSG_NOSIGNAL), ssize_t{sizeof request});
  }
  void step(std::uint32_t ticks) { ask(1, ticks, 0); }
  void restart(std::uint64_t seed) { ask(2, 0, seed); }
  /// Why not; empty: done.
  std::string answer() {
    std::uint32_t head[2] = {1, 0};
    EXPECT_EQ(recv(program_, head, sizeof head, MSG_WAITALL), ssize_t{sizeof head});
    std::string text(head[1], '\0');
    if (!text.empty()) {
      EXPECT_EQ(recv(program_, text.data(), text.size(), MSG_WAITALL), static_cast<ssize_t>(text.size()));
    }
    EXPECT_EQ(head[0] != 0, !text.empty());
    return text;
  }
  int program_ = -1;
  std::unique_ptr<Link> link_;
  std::thread ticks_;
};

TEST_F(LinkedGym, begins_again_also_while_others_fill_the_queue) {
  step(5);
  EXPECT_EQ(answer(), "");
  std::atomic<bool> is_full = false;
  ASSERT_TRUE(simulation_.requests().post([&](const world::Journal&) {
    while (!is_full) std::this_thread::yield();
  }));
  while (simulation_.requests().post([](const world::Journal&) {})) {
  }
  restart(9);
  while (!simulation_.lock_step()->is_due()) std::this_thread::yield();
  is_full = true;
  EXPECT_EQ(answer(), "");
  EXPECT_EQ(world().tick(), 1u);
  EXPECT_EQ(world().seed(), 9u);
}

}  // namespace
}  // namespace playhouse::drivers::gym
