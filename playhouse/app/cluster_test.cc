// A head and its nodes: the same run as alone, whoever comes, goes, is silent, or says something else.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <fstream>
#include <map>
#include <string>
#include <thread>

#include "playhouse/app/world_opener.h"
#include "playhouse/base/formats.h"
#include "playhouse/base/packing.h"
#include "playhouse/base/testing/wait.h"
#include "playhouse/base/version.h"
#include "playhouse/cluster/head.h"
#include "playhouse/cluster/hello.h"
#include "playhouse/cluster/node.h"
#include "playhouse/net/polled/system_polled.h"
#include "playhouse/scene/world_loader.h"
#include "playhouse/world/population/population.h"
#include "playhouse/world/saving/state.h"

namespace playhouse::app {
namespace {

using cluster::Head;
using cluster::MessageStream;
using cluster::NodeMessageType;
using cluster::Seconds;
using testing::HasSubstr;
using testing::MatchesRegex;

constexpr Seconds kLong{60};

/// Memory of this process.
std::size_t resident_bytes() {
  std::size_t all = 0, resident = 0;
  std::ifstream("/proc/self/statm") >> all >> resident;
  return resident * static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
}

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
  explicit Instance(config::SourceFiles sources, const std::string& engine = kStage, std::uint64_t seed = 1)
      : sources(std::move(sources)), scene_(*scene_of(this->sources, std::nullopt, nullptr)) {
    this->engine = *make_engine(scene_, {.engine = engine, .seed = seed},
                                controllers::Libraries::LibraryUse::kLoad, [](const std::string&) {});
  }
  static config::SourceFiles test_world() {
    config::SourceFiles sources;
    sources.path = "test.world";
    sources.files["test.world"] = kWorld;
    return sources;
  }

  config::SourceFiles sources;

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
          cluster::Node node(*MessageStream::connect(net::system_polled(), "127.0.0.1", port, kLong));
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

int connected_to(std::uint16_t port) {
  const int socket = ::socket(AF_INET, SOCK_STREAM, 0);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(port);
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  EXPECT_EQ(connect(socket, reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
  return socket;
}

class ClusterTest : public testing::Test {
 protected:
  using Hashes = std::vector<std::pair<std::uint64_t, std::uint64_t>>;

  void begin(std::size_t nodes, Seconds patience = kLong) {
    run_ = std::make_unique<Instance>(Instance::test_world());
    head_ = std::make_unique<Head>(net::system_polled(), std::move(run_->engine), run_->sources,
                                   Head::HeadOptions{.nodes = nodes, .patience = patience},
                                   [this](const Error& why) { failure_ = why.line(); });
    port_ = *head_->listen();
  }
  world::World& world() { return head_->world(); }
  void change(const std::function<void(world::Journal&)>& change) {
    world::Journal journal(world());
    change(journal);
    journal.apply(world::changes::StartControllers{});
    head_->changed(world(), journal.entries());
  }
  static void step(world::Engine& engine, int ticks, Hashes& hashes) {
    for (int i = 0; i < ticks; ++i) {
      engine.step();
      hashes.emplace_back(engine.world().hash(), engine.world().sensed_hash());
    }
  }
  /// `act(change, step)` on a head with two nodes: the truth is what it does alone.
  template <typename Act>
  void expect_same_on_two_nodes(const Act& act) {
    Instance alone(Instance::test_world());
    Hashes wanted, hashes;
    act(
        [&](const auto& made) {
          world::Journal journal(alone.engine->world());
          made(journal);
          journal.apply(world::changes::StartControllers{});
        },
        [&](int ticks) { step(*alone.engine, ticks, wanted); });
    begin(2);
    NodeThread first(head_, port_), second(head_, port_);
    act([&](const auto& made) { change(made); }, [&](int ticks) { step(*head_, ticks, hashes); });
    EXPECT_EQ(hashes, wanted);
    EXPECT_EQ(head_->nodes(), 2u);
    EXPECT_EQ(failure_, "");
    const std::uint64_t hash = world().hash();
    head_.reset();
    ASSERT_TRUE(first.join()) << first.join().error().line();
    EXPECT_EQ(first.world().hash(), hash);
  }
  static Hashes alone(int ticks) {
    Instance run(Instance::test_world());
    Hashes hashes;
    step(*run.engine, ticks, hashes);
    return hashes;
  }
  /// Steps until the head has so many nodes.
  bool step_until(std::size_t nodes, Hashes& hashes) {
    return wait_until([&] {
      if (head_->nodes() != nodes) step(*head_, 1, hashes);
      return head_->nodes() == nodes;
    });
  }
  /// A node of a few lines that has joined, and has received its first step.
  MessageStream joined() { return joined(*net::system_polled().connect("127.0.0.1", port_, kLong.count())); }
  MessageStream joined(std::unique_ptr<net::PolledStream> pipe) {
    MessageStream stream(net::system_polled(), std::move(pipe), SIZE_MAX);
    EXPECT_TRUE(stream.send(NodeMessageType::kHello, {cluster::hello()}, kLong));
    EXPECT_TRUE(stream.send(NodeMessageType::kReady, {}, kLong));
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
  const auto act = [&](const auto& change, const auto& step) {
    step(10);
    change([](world::Journal& journal) {
      journal.apply(world::changes::Place{journal.world().id(journal.world().find("a")), {1, 1, 0, 1}});
    });
    step(10);
    change([](world::Journal& journal) {
      ASSERT_TRUE(
          journal.spawn(journal.world().models.desc[journal.world().find("b")], {4, 4, 0, 0}, "late"));
    });
    step(10);
    change([](world::Journal& journal) {
      ASSERT_TRUE(journal.despawn(journal.world().id(journal.world().find("c"))));
    });
    change([](world::Journal& journal) {
      journal.apply(world::changes::Subscribe{journal.world().id(journal.world().find("d"))});
    });
    step(100);
  };
  expect_same_on_two_nodes(act);
}

/// Loads of a state while nobody ticks, and more changes than are sent one by one.
TEST_F(ClusterTest, a_run_taken_back_is_so_on_all_nodes) {
  std::shared_ptr<const Bytes> state;
  const auto keep = [&](world::Journal& journal) {
    Bytes bytes;
    ASSERT_TRUE(world::save_state(journal.world(), bytes));
    state = std::make_shared<const Bytes>(std::move(bytes));
  };
  const auto take_back = [&](world::Journal& journal) {
    for (int time = 0; time < 20; ++time) ASSERT_TRUE(journal.load(state, journal.world().seed()));
    journal.apply(world::changes::Place{journal.world().id(journal.world().find("a")), {1, 1, 0, 1}});
  };
  const auto change_much = [](world::Journal& journal) {
    const world::ModelId b = journal.world().id(journal.world().find("b"));
    for (int time = 0; time < 40000; ++time)
      journal.apply(world::changes::Place{b, {4, 4 - 0.0001 * time, 0, 0}});
  };
  const auto act = [&](const auto& change, const auto& step) {
    step(10);
    change(keep);
    step(30);
    change(take_back);
    step(30);
    change(change_much);
    step(120);
  };
  expect_same_on_two_nodes(act);
}

TEST_F(ClusterTest, nodes_join_a_run_and_leave_it) {
  begin(0);
  Hashes hashes;
  step(*head_, 20, hashes);
  NodeThread late(head_, port_);
  ASSERT_TRUE(step_until(1, hashes));
  { const MessageStream leaver = joined(); }  // gone before its first share
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
  MessageStream silent = joined();
  Hashes hashes;
  step(*head_, 30, hashes);
  EXPECT_EQ(head_->nodes(), 1u);
  EXPECT_EQ(hashes, alone(30));
}

/// What a node shares in the first ticks of the test's world: share 1 of 2.
class FirstShares : private world::Division {
 public:
  explicit FirstShares(int ticks) : run_(Instance::test_world()) {
    run_.engine->divide(this);
    for (int tick = 0; tick < ticks; ++tick) {
      hashes_ = {run_.engine->world().hash(), run_.engine->world().sensed_hash()};
      run_.engine->step();
    }
  }
  /// The body of a message kShare at this tick, the first one with the hashes of a check.
  Bytes of(std::size_t tick) const { return shares_[tick]; }

 private:
  void run(world::DividedWork& work) override {
    Bytes share, other;
    if (shares_.empty()) {
      Packer(share).u64(hashes_.first);
      Packer(share).u64(hashes_.second);
    }
    work.compute({1, 2}, share);
    work.compute({0, 2}, other);
    shares_.push_back(std::move(share));
  }

  Instance run_;
  std::pair<std::uint64_t, std::uint64_t> hashes_;
  std::vector<Bytes> shares_;
};

const std::vector<Bytes> kInvalidShares = {{}, Bytes(3), Bytes(16), Bytes(17), Bytes(5000, std::byte{0xFF})};

TEST_F(ClusterTest, a_node_whose_first_share_is_another_is_refused_and_the_run_goes_on) {
  for (const Bytes& share : kInvalidShares) {
    begin(1);
    MessageStream bad = joined();
    EXPECT_TRUE(bad.send(NodeMessageType::kShare, {share}, kLong));
    Hashes hashes;
    step(*head_, 10, hashes);
    EXPECT_EQ(head_->nodes(), 0u);
    EXPECT_EQ(failure_, "");
    EXPECT_EQ(hashes, alone(10));
  }
  begin(1);
  MessageStream wrong = joined();
  Bytes share = FirstShares(1).of(0);
  share.back() ^= std::byte{1};
  EXPECT_TRUE(wrong.send(NodeMessageType::kShare, {share}, kLong));
  head_->step();
  EXPECT_EQ(head_->nodes(), 0u);
  EXPECT_EQ(failure_, "");
}

TEST_F(ClusterTest, a_node_that_took_part_and_measures_something_else_fails_the_run) {
  const FirstShares right(1);
  for (const Bytes& share : kInvalidShares) {
    begin(1);
    MessageStream bad = joined();
    EXPECT_TRUE(bad.send(NodeMessageType::kShare, {right.of(0)}, kLong));
    head_->step();
    EXPECT_EQ(head_->nodes(), 1u);
    EXPECT_TRUE(bad.send(NodeMessageType::kShare, {share}, kLong));
    head_->step();
    EXPECT_EQ(head_->nodes(), 0u);
    EXPECT_THAT(failure_, HasSubstr("cluster: 127.0.0.1:"));
    EXPECT_THAT(failure_, HasSubstr("at 0.1 s "));
    failure_.clear();
  }
}

TEST_F(ClusterTest, whoever_sends_byte_by_byte_holds_a_tick_no_longer_than_whoever_is_silent) {
  begin(1, Seconds{0.3});
  const int socket = connected_to(port_);
  const MessageStream slow = joined(net::polled_stream_of(dup(socket)));
  std::atomic<bool> over = false;
  std::thread trickle([&] {
    const std::array<unsigned char, 5> announced{
        0, 0, 0, 1, static_cast<unsigned char>(NodeMessageType::kShare)};  // 16 MiB
    for (std::size_t i = 0; !over; ++i) {
      const unsigned char byte = i < announced.size() ? announced[i] : 0;
      if (::send(socket, &byte, 1, MSG_NOSIGNAL) < 0) break;
      std::this_thread::yield();
    }
  });
  Hashes hashes;
  step(*head_, 2, hashes);
  over = true;
  trickle.join();
  close(socket);
  EXPECT_EQ(head_->nodes(), 0u);
  EXPECT_EQ(hashes, alone(2));
}

TEST_F(ClusterTest, after_a_silent_node_its_address_waits_for_the_next) {
  begin(1, Seconds{0.1});
  const MessageStream silent = joined();
  Hashes hashes;
  step(*head_, 2, hashes);
  ASSERT_EQ(head_->nodes(), 0u);
  MessageStream next = joined();
  head_->step();
  const Result<cluster::NodeMessage> said = next.wait(kLong);
  ASSERT_TRUE(said);
  EXPECT_EQ(said->type, NodeMessageType::kRefusal);
  Unpacker in(said->body);
  EXPECT_THAT(in.text(), HasSubstr("a node at its address was silent: in "));
}

TEST_F(ClusterTest, silent_connections_keep_no_node_out) {
  begin(0);
  std::vector<MessageStream> silent;
  for (int i = 0; i < 300; ++i)
    silent.push_back(*MessageStream::connect(net::system_polled(), "127.0.0.1", port_, kLong));
  Hashes hashes;
  step(*head_, 3, hashes);
  NodeThread node(head_, port_);
  EXPECT_TRUE(step_until(1, hashes));
}

TEST_F(ClusterTest, a_hundred_nodes_that_do_not_read_share_one_copy_of_the_world) {
  config::SourceFiles sources = Instance::test_world();
  sources.files["test.world"] += "\n# " + std::string(8 << 20, 'x');
  run_ = std::make_unique<Instance>(sources);
  head_ = std::make_unique<Head>(net::system_polled(), std::move(run_->engine), run_->sources,
                                 Head::HeadOptions{}, [](const Error&) {});
  port_ = *head_->listen();
  std::vector<MessageStream> streams;
  for (int i = 0; i < 100; ++i) {
    streams.push_back(*MessageStream::connect(net::system_polled(), "127.0.0.1", port_, kLong));
    EXPECT_TRUE(streams.back().send(NodeMessageType::kHello, {cluster::hello()}, kLong));
  }
  const std::size_t before = resident_bytes();
  head_->step();
  EXPECT_LT(resident_bytes(), before + (std::size_t{100} << 20));  // a copy each would be 800 MB
}

TEST_F(ClusterTest, nodes_need_the_token_of_the_run) {
  run_ = std::make_unique<Instance>(Instance::test_world());
  head_ = std::make_unique<Head>(net::system_polled(), std::move(run_->engine), run_->sources,
                                 Head::HeadOptions{.token = "secret"}, [](const Error&) {});
  port_ = *head_->listen();
  for (const std::string token : {"", "secre", "secret2"}) {
    MessageStream stranger = *MessageStream::connect(net::system_polled(), "127.0.0.1", port_, kLong);
    EXPECT_TRUE(stranger.send(NodeMessageType::kHello, {cluster::hello(token)}, kLong));
    head_->step();
    const Result<cluster::NodeMessage> said = stranger.wait(kLong);
    ASSERT_TRUE(said);
    EXPECT_EQ(said->type, NodeMessageType::kRefusal) << token;
  }
  MessageStream node = *MessageStream::connect(net::system_polled(), "127.0.0.1", port_, kLong);
  EXPECT_TRUE(node.send(NodeMessageType::kHello, {cluster::hello("secret")}, kLong));
  head_->step();
  head_->step();
  const Result<cluster::NodeMessage> said = node.wait(kLong);
  ASSERT_TRUE(said);
  EXPECT_EQ(said->type, NodeMessageType::kWorld);
}

/// A server that accepts one connection, and does with it what is asked.
Result<cluster::Node::Summary> node_of(const std::function<void(int socket)>& head) {
  const int listener = socket(AF_INET, SOCK_STREAM, 0);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  socklen_t size = sizeof address;
  EXPECT_EQ(bind(listener, reinterpret_cast<sockaddr*>(&address), size), 0);
  EXPECT_EQ(listen(listener, 1), 0);
  EXPECT_EQ(getsockname(listener, reinterpret_cast<sockaddr*>(&address), &size), 0);
  cluster::Node node(
      *MessageStream::connect(net::system_polled(), "127.0.0.1", ntohs(address.sin_port), kLong), "",
      Seconds{0.2});
  const int peer = accept(listener, nullptr, nullptr);
  head(peer);
  const Result<cluster::Node::Summary> done = node.run([](world::SavedRun) -> Result<world::Engine*> {
    return Error{"", "no world"};
  });
  close(peer);
  close(listener);
  return done;
}

TEST(ClusterNodeTest, a_head_that_says_nothing_is_not_waited_for_for_ever) {
  const Result<cluster::Node::Summary> done = node_of([](int) {});
  ASSERT_FALSE(done);
  EXPECT_EQ(done.error().text, "is silent for 0.2 s");
}

TEST(ClusterNodeTest, a_head_that_announces_4_GiB_is_left) {
  const Result<cluster::Node::Summary> done = node_of([](int socket) {
    const std::array<unsigned char, 5> head{0xFF, 0xFF, 0xFF, 0xFF,
                                            static_cast<unsigned char>(NodeMessageType::kWorld)};
    EXPECT_EQ(send(socket, head.data(), head.size(), 0), 5);
  });
  ASSERT_FALSE(done);
  EXPECT_EQ(done.error().text, "sent a message of 4294967295 bytes, 1073741824 at most");
}

TEST_F(ClusterTest, strangers_are_refused) {
  begin(0);
  MessageStream garbage = *MessageStream::connect(net::system_polled(), "127.0.0.1", port_, kLong),
                large = *MessageStream::connect(net::system_polled(), "127.0.0.1", port_, kLong),
                early = *MessageStream::connect(net::system_polled(), "127.0.0.1", port_, kLong),
                other_format = *MessageStream::connect(net::system_polled(), "127.0.0.1", port_, kLong),
                other_build = *MessageStream::connect(net::system_polled(), "127.0.0.1", port_, kLong);
  EXPECT_TRUE(garbage.send(static_cast<NodeMessageType>(99), {Bytes(8)}, kLong));
  EXPECT_TRUE(large.send(NodeMessageType::kHello, {Bytes(100'000)}, kLong));
  EXPECT_TRUE(early.send(NodeMessageType::kReady, {}, kLong));
  const auto hello = [](const std::string& format, const std::string& build) {
    Bytes body;
    for (const std::string& text : {"playhouse cluster " + format, build, std::string()})
      Packer(body).text(text);
    return body;
  };
  const std::string format = std::to_string(formats::kCluster);
  EXPECT_TRUE(other_format.send(NodeMessageType::kHello, {hello("2", "0.1.0")}, kLong));
  EXPECT_TRUE(other_build.send(NodeMessageType::kHello, {hello(format, std::string(build()) + "x")}, kLong));
  const auto said_by = [&](MessageStream& stream) -> std::string {
    for (;;) {
      head_->step();
      const Result<cluster::NodeMessage> message = stream.wait(Seconds{0.01});
      if (!message && message.error().text.starts_with("is silent")) continue;
      if (!message) return message.error().text;
      Unpacker in(message->body);
      return in.text();
    }
  };
  for (MessageStream* const stream : {&garbage, &large, &early})
    EXPECT_THAT(said_by(*stream), HasSubstr("onnection"));
  EXPECT_EQ(said_by(other_format), "it speaks format \"2\" of clusters, the run format " + format);
  EXPECT_THAT(said_by(other_build), MatchesRegex("it is Playhouse \".*x\", the run \".*\""));
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
