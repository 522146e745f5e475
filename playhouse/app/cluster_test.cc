// A head and its nodes: the same run as alone, whoever comes, goes, is silent, or says something else.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <thread>

#include "playhouse/app/world_opener.h"
#include "playhouse/base/packing.h"
#include "playhouse/cluster/head.h"
#include "playhouse/cluster/hello.h"
#include "playhouse/cluster/node.h"
#include "playhouse/scene/world_loader.h"
#include "playhouse/world/population.h"

namespace playhouse::app {
namespace {

using cluster::Bytes;
using cluster::Head;
using cluster::Seconds;
using cluster::Stream;
using cluster::Type;
using testing::HasSubstr;

constexpr Seconds kLong{60};

constexpr const char* kWorld = R"(
interval_sim 100
define robot position( size [0.4 0.4 0.2] ctrl "wander"
  ranger( size [0.1 0.1 0.1] sensor( range [0 8] fov 180 samples 30 noise [0.01 0.01 0] ) ) )
model( name "walls" size [12 12 1] boundary 1 noblocks 1 )
robot( name "a" pose [-3 -3 0 10] ) robot( name "b" pose [0 -3 0 70] ) robot( name "c" pose [3 -3 0 150] )
robot( name "d" pose [-3 0 0 200] ) robot( name "e" pose [0 0 0 300] ) robot( name "f" pose [3 0 0 340] ))";

/// The engine of the world, with what it refers to.
class Instance {
 public:
  explicit Instance(scene::SourceFiles sources, const std::string& engine = kStage, std::uint64_t seed = 1)
      : sources(std::move(sources)), scene_(*scene_of(this->sources, std::nullopt, nullptr)) {
    this->engine = *make_engine(scene_, {.engine = engine, .seed = seed}, controllers::Libraries::Use::kLoad,
                                [](const std::string&) {});
  }
  static scene::SourceFiles test_world() {
    scene::SourceFiles sources;
    sources.path = "test.world";
    sources.files["test.world"] = kWorld;
    return sources;
  }

  scene::SourceFiles sources;

 private:
  scene::SceneDesc scene_;

 public:
  std::unique_ptr<world::Engine> engine;
};

/// A node in a thread of its own.
class NodeThread {
 public:
  NodeThread(std::unique_ptr<Head>& head, std::uint16_t port)
      : head_(head), thread_([this, port] {
          cluster::Node node(*Stream::connect("127.0.0.1", port, kLong));
          result_ = node.run([this](world::SavedRun run) -> Result<world::Engine*> {
            run_ = std::make_unique<Instance>(run.sources, run.engine, run.seed);
            return run_->engine.get();
          });
        }) {}
  ~NodeThread() {
    head_.reset();  // which ends the run
    if (thread_.joinable()) thread_.join();
  }
  const Result<cluster::Node::Summary>& join() {
    if (thread_.joinable()) thread_.join();
    return result_;
  }
  /// After join().
  world::World& world() { return run_->engine->world(); }

 private:
  std::unique_ptr<Head>& head_;
  Result<cluster::Node::Summary> result_ = Error{"", "has not run"};
  std::unique_ptr<Instance> run_;
  std::thread thread_;
};

class ClusterTest : public testing::Test {
 protected:
  using Hashes = std::vector<std::pair<std::uint64_t, std::uint64_t>>;

  void begin(std::size_t nodes, Seconds patience = kLong) {
    run_ = std::make_unique<Instance>(Instance::test_world());
    head_ = std::make_unique<Head>(std::move(run_->engine), run_->sources,
                                   Head::Options{.nodes = nodes, .patience = patience},
                                   [this](const Error& why) { failure_ = why.line(); });
    port_ = *head_->listen();
  }
  world::World& world() { return head_->world(); }
  void change(const std::function<void(world::World&)>& change) {
    head_->before_changes(world());
    change(world());
    for (const auto& decider : world().deciders) decider->follow(world());
    head_->after_changes(world());
  }
  static void step(world::Engine& engine, int ticks, Hashes& hashes) {
    for (int i = 0; i < ticks; ++i) {
      engine.step();
      hashes.emplace_back(engine.world().hash(), engine.world().sensed_hash());
    }
  }
  static Hashes alone(int ticks) {
    Instance run(Instance::test_world());
    Hashes hashes;
    step(*run.engine, ticks, hashes);
    return hashes;
  }
  /// Steps until the head has so many nodes.
  bool step_until(std::size_t nodes, Hashes& hashes) {
    const auto deadline = std::chrono::steady_clock::now() + kLong;
    while (head_->nodes() != nodes && std::chrono::steady_clock::now() < deadline) step(*head_, 1, hashes);
    return head_->nodes() == nodes;
  }
  /// A node of a few lines that has joined, and has received its first step.
  Stream joined() {
    Stream stream = *Stream::connect("127.0.0.1", port_, kLong);
    EXPECT_TRUE(stream.send(Type::kHello, {cluster::hello()}, kLong));
    EXPECT_TRUE(stream.send(Type::kReady, {}, kLong));
    return stream;
  }

  std::unique_ptr<Instance> run_;
  std::unique_ptr<Head> head_;
  std::uint16_t port_ = 0;
  std::string failure_;
};

TEST_F(ClusterTest, does_what_one_program_does_alone) {
  for (const std::size_t nodes : {1, 2, 5, 8}) {
    begin(nodes);
    std::vector<std::unique_ptr<NodeThread>> threads;
    for (std::size_t i = 0; i < nodes; ++i) threads.push_back(std::make_unique<NodeThread>(head_, port_));
    Hashes hashes;
    step(*head_, 250, hashes);  // with three checks
    EXPECT_EQ(head_->nodes(), nodes);
    EXPECT_EQ(hashes, alone(250)) << nodes;
    const std::uint64_t hash = world().hash(), sensed = world().sensed_hash(), rays = head_->rays();
    head_.reset();
    for (const auto& node : threads) {
      ASSERT_TRUE(node->join()) << node->join().error().line();
      EXPECT_EQ(node->join()->ticks, 250u);
      EXPECT_EQ(node->world().hash(), hash);
      EXPECT_EQ(node->world().sensed_hash(), sensed);
    }
    EXPECT_EQ(rays, 250u * 6 * 30);
    EXPECT_EQ(failure_, "");
  }
}

TEST_F(ClusterTest, changes_between_ticks_reach_all_nodes) {
  const auto act = [&](const std::function<void(const std::function<void(world::World&)>&)>& change,
                       const std::function<void(int)>& step) {
    step(10);
    change([](world::World& world) { world::set_pose(world, world.find("a"), {1, 1, 0, 1}); });
    step(10);
    change([](world::World& world) {
      ASSERT_TRUE(world::spawn(world, world.models.desc[world.find("b").index], {4, 4, 0, 0}, "late"));
    });
    step(10);
    change([](world::World& world) { ASSERT_TRUE(world::despawn(world, world.id(world.find("c")))); });
    change([](world::World& world) { world::subscribe(world, world.find("d")); });
    step(100);
  };
  Instance alone(Instance::test_world());
  Hashes wanted, hashes;
  act(
      [&](const auto& change) {
        change(alone.engine->world());
        for (const auto& decider : alone.engine->world().deciders) decider->follow(alone.engine->world());
      },
      [&](int ticks) { step(*alone.engine, ticks, wanted); });
  begin(2);
  NodeThread first(head_, port_), second(head_, port_);
  act([&](const auto& change) { this->change(change); }, [&](int ticks) { step(*head_, ticks, hashes); });
  EXPECT_EQ(hashes, wanted);
  EXPECT_EQ(head_->nodes(), 2u);
  const std::uint64_t hash = world().hash();
  head_.reset();
  ASSERT_TRUE(first.join()) << first.join().error().line();
  EXPECT_EQ(first.world().hash(), hash);
}

TEST_F(ClusterTest, nodes_join_a_run_and_leave_it) {
  begin(0);
  Hashes hashes;
  step(*head_, 20, hashes);
  NodeThread late(head_, port_);
  ASSERT_TRUE(step_until(1, hashes));
  { const Stream leaver = joined(); }  // gone before its first share
  ASSERT_TRUE(step_until(1, hashes));
  step(*head_, 20, hashes);
  EXPECT_EQ(hashes, alone(static_cast<int>(hashes.size())));
  const std::uint64_t hash = world().hash();
  head_.reset();
  ASSERT_TRUE(late.join()) << late.join().error().line();
  EXPECT_EQ(late.world().hash(), hash);
}

TEST_F(ClusterTest, a_node_that_says_nothing_is_lost_and_its_share_is_not) {
  begin(2, Seconds{0.3});
  NodeThread good(head_, port_);
  Stream silent = joined();
  Hashes hashes;
  step(*head_, 30, hashes);
  EXPECT_EQ(head_->nodes(), 1u);
  EXPECT_EQ(hashes, alone(30));
}

TEST_F(ClusterTest, shares_that_are_none_fail_the_run) {
  const std::vector<Bytes> shares = {{}, Bytes(3), Bytes(17), Bytes(5000, std::byte{0xFF})};
  for (const Bytes& share : shares) {
    begin(1);
    Stream bad = joined();
    // The first tick is a check, which compares; in the second the share is used.
    Hashes hashes;
    EXPECT_TRUE(bad.send(Type::kShare, {share}, kLong));
    EXPECT_TRUE(bad.send(Type::kShare, {share}, kLong));
    step(*head_, 10, hashes);
    EXPECT_EQ(head_->nodes(), 0u);
    EXPECT_THAT(failure_, HasSubstr("cluster: 127.0.0.1:"));
    failure_.clear();
  }
}

TEST_F(ClusterTest, a_node_that_measures_something_else_fails_the_run) {
  begin(1);
  Stream wrong = joined();
  Instance run(Instance::test_world());
  Bytes share;
  Packer(share).u64(run.engine->world().hash());
  Packer(share).u64(run.engine->world().sensed_hash() + 1);
  Packer(share).varint(0);
  EXPECT_TRUE(wrong.send(Type::kShare, {share}, kLong));
  head_->step();
  EXPECT_THAT(failure_, HasSubstr("cluster: 127.0.0.1:"));
  EXPECT_THAT(failure_, HasSubstr("at 0.0 s its world is another one"));
}

TEST_F(ClusterTest, strangers_are_refused) {
  begin(0);
  Stream garbage = *Stream::connect("127.0.0.1", port_, kLong),
         large = *Stream::connect("127.0.0.1", port_, kLong),
         early = *Stream::connect("127.0.0.1", port_, kLong),
         other = *Stream::connect("127.0.0.1", port_, kLong);
  EXPECT_TRUE(garbage.send(static_cast<Type>(99), {Bytes(8)}, kLong));
  EXPECT_TRUE(large.send(Type::kHello, {Bytes(100'000)}, kLong));
  EXPECT_TRUE(early.send(Type::kReady, {}, kLong));
  Bytes hello;
  Packer(hello).text("playhouse cluster 1");
  Packer(hello).text("0.0.1");
  EXPECT_TRUE(other.send(Type::kHello, {hello}, kLong));
  const auto said_by = [&](Stream& stream) -> std::string {
    for (;;) {
      head_->step();
      const Result<cluster::Message> message = stream.wait(Seconds{0.01});
      if (!message && message.error().text.starts_with("is silent")) continue;
      if (!message) return message.error().text;
      Unpacker in(message->body);
      return in.text();
    }
  };
  for (Stream* const stream : {&garbage, &large, &early})
    EXPECT_THAT(said_by(*stream), HasSubstr("onnection"));
  EXPECT_THAT(said_by(other), HasSubstr("it is version \"0.0.1\" of Playhouse, the run \""));
  EXPECT_EQ(head_->nodes(), 0u);
}

TEST_F(ClusterTest, a_head_that_is_stopped_waits_for_no_nodes) {
  begin(3);
  std::thread other([&] { head_->stop(); });
  head_->step();
  other.join();
  EXPECT_EQ(world().tick(), 1u);
}

}  // namespace
}  // namespace playhouse::app
