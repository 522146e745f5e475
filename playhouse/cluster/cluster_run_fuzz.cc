// A run of a cluster whose other side says anything in any order: a node with such a head ('n' first), a head
// with such a node ('h'). Then a byte for each message: of its type 1 to 8, with a size of one byte and a
// body; or a word for one as it should be: 'w' the world, 's' a step with the state, 'c' one without, 'i'
// hello, 'r' ready, 'm' measurements.

#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "playhouse/base/assert.h"
#include "playhouse/base/fuzz_script.h"
#include "playhouse/base/log.h"
#include "playhouse/base/packing.h"
#include "playhouse/cluster/head.h"
#include "playhouse/cluster/hello.h"
#include "playhouse/cluster/node.h"
#include "playhouse/net/polled/system_polled.h"
#include "playhouse/scene/world_loader.h"
#include "playhouse/world/saving/saved_run.h"
#include "playhouse/world/saving/sensed_rows.h"
#include "playhouse/world/saving/whole_state.h"

namespace {

using namespace playhouse;
using cluster::NodeMessageType;

constexpr const char* kWorld =
    "define robot position( ranger( sensor( samples 9 ) ) )\n"
    "robot( name \"a\" ) robot( name \"b\" pose [2 0 0 0] )\n";
constexpr std::size_t kStreamBytes = 16 << 10;
constexpr int kTicks = 5;

const scene::SceneDesc& the_scene() {
  static config::MemoryFiles files({}, {});
  static const Result<scene::SceneDesc> scene = scene::load_world_text(kWorld, "fuzz.world", files);
  PLAYHOUSE_ASSERT(scene.ok());
  return *scene;
}

/// Time goes on, and the ranges of all rangers are shared.
class SharingEngine final : public world::Engine, private world::DividedWork {
 public:
  void step() override {
    if (division_ != nullptr) division_->run(*this);
    world_.tick_++;
  }
  world::World& world() override { return world_; }
  world::Workers& workers() override { return workers_; }
  void divide(world::Division* division) override { division_ = division; }
  std::uint64_t rays() const override { return 0; }

 private:
  std::vector<world::KindRow> rows(world::Share share) const {
    const std::size_t all = world_.rangers.size(), begin = share.begin(all);
    std::vector<world::KindRow> rows(share.end(all) - begin);
    for (std::size_t i = 0; i < rows.size(); ++i) rows[i] = {{static_cast<std::uint32_t>(begin + i)}};
    return rows;
  }
  void compute(world::Share share, Bytes& out) override {
    world::pack_sensed(world_, scene::ModelKind::kRanger, rows(share), out);
  }
  bool take(world::Share share, std::span<const std::byte> results) override {
    Unpacker in(results);
    return world::unpack_sensed(world_, scene::ModelKind::kRanger, rows(share), in) && in.at_end();
  }

  world::World world_{the_scene(), 1};
  world::Workers workers_{1};
  world::Division* division_ = nullptr;
};

void add(Bytes& stream, NodeMessageType type, std::span<const std::byte> body) {
  Packer(stream).u32(static_cast<std::uint32_t>(body.size()));
  Packer(stream).u8(static_cast<std::uint8_t>(type));
  stream.insert(stream.end(), body.begin(), body.end());
}

Bytes step_of(bool with_state) {
  Bytes state, body;
  SharingEngine engine;
  if (with_state) PLAYHOUSE_ASSERT(world::save_whole(engine.world(), state));
  cluster::encode(cluster::Step{{1, 2}, with_state, state, {}}, body);
  return body;
}

Bytes measurements(bool with_hashes) {
  Bytes body;
  SharingEngine engine;
  if (with_hashes) {
    Packer(body).u64(engine.world().hash());
    Packer(body).u64(engine.world().sensed_hash());
  }
  world::pack_sensed(engine.world(), scene::ModelKind::kRanger, std::array<world::KindRow, 1>{{{{1}}}}, body);
  return body;
}

Bytes stream_of(FuzzScript& script) {
  Bytes stream;
  for (bool is_first = true; !script.done() && stream.size() < kStreamBytes;) {
    const std::uint8_t what = script.byte();
    switch (what) {
      case 'w':
        add(stream, NodeMessageType::kWorld,
            world::encode(
                world::SavedRun{{.path = "fuzz.world", .files = {{"fuzz.world", kWorld}}}, "", 1, {}}));
        break;
      case 's':
        add(stream, NodeMessageType::kStep, step_of(true));
        break;
      case 'c':
        add(stream, NodeMessageType::kStep, step_of(false));
        break;
      case 'i':
        add(stream, NodeMessageType::kHello, cluster::hello(""));
        break;
      case 'r':
        add(stream, NodeMessageType::kReady, {});
        break;
      case 'm':
        add(stream, NodeMessageType::kShare, measurements(std::exchange(is_first, false)));
        break;
      default:
        add(stream, static_cast<NodeMessageType>(what), script.take(script.byte()));
    }
  }
  return stream;
}

void say(int socket, const Bytes& stream) {
  PLAYHOUSE_ASSERT(send(socket, stream.data(), stream.size(), MSG_NOSIGNAL) ==
                   static_cast<ssize_t>(stream.size()));
  shutdown(socket, SHUT_WR);
}

void run_node(FuzzScript script) {
  std::array<int, 2> ends{};
  PLAYHOUSE_ASSERT(socketpair(AF_UNIX, SOCK_STREAM, 0, ends.data()) == 0);
  say(ends[1], stream_of(script));
  SharingEngine engine;
  cluster::Node node(cluster::MessageStream(net::system_polled(), net::polled_stream_of(ends[0]), 0));
  const auto summary = node.run([&](world::SavedRun) -> Result<world::Engine*> { return &engine; });
  PLAYHOUSE_ASSERT(summary.ok() || !summary.error().line().empty());
  close(ends[1]);
}

int connected_to(std::uint16_t port) {
  const int socket = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(port);
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  PLAYHOUSE_ASSERT(connect(socket, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0);
  const linger at_once{1, 0};  // no port stays behind
  setsockopt(socket, SOL_SOCKET, SO_LINGER, &at_once, sizeof at_once);
  return socket;
}

/// Whatever a node says, the run goes on; it is ended only where measurements differ.
void run_head(FuzzScript script) {
  cluster::Head head(net::system_polled(), std::make_unique<SharingEngine>(),
                     {.path = "fuzz.world", .files = {{"fuzz.world", kWorld}}, .search_path = {}},
                     {.patience = cluster::Seconds{1}},
                     [](const Error& error) { PLAYHOUSE_ASSERT(!error.line().empty()); });
  const Result<std::uint16_t> port = head.listen();
  PLAYHOUSE_ASSERT(port.ok());
  const int peer = connected_to(*port);
  say(peer, stream_of(script));
  for (int tick = 1; tick <= kTicks; ++tick) {
    head.step();
    PLAYHOUSE_ASSERT(head.world().tick() == static_cast<std::uint64_t>(tick));
  }
  close(peer);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  log::silence();
  FuzzScript script(std::as_bytes(std::span(data, size)));
  switch (script.byte()) {
    case 'n':
      run_node(script);
      break;
    case 'h':
      run_head(script);
      break;
    default:
      break;
  }
  return 0;
}
