// Any bytes are messages of a cluster, a step, a hello and measurements, or are refused.

#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <cstdint>
#include <string_view>

#include "playhouse/base/assert.h"
#include "playhouse/cluster/hello.h"
#include "playhouse/cluster/step.h"
#include "playhouse/cluster/stream.h"
#include "playhouse/config/text/source_text.h"
#include "playhouse/net/polled/system_polled.h"
#include "playhouse/scene/world_loader.h"
#include "playhouse/world/saving/sensed_rows.h"

namespace {

using namespace playhouse;

constexpr const char* kWorld =
    "define robot position( ranger( sensor( samples 9 ) ) fiducial() blobfinder() camera() detector() )\n"
    "robot( name \"a\" ) robot( name \"b\" pose [2 0 0 0] )\n";

void read_messages(std::span<const std::byte> bytes) {
  std::array<int, 2> ends{};
  PLAYHOUSE_ASSERT(socketpair(AF_UNIX, SOCK_STREAM, 0, ends.data()) == 0);
  cluster::MessageStream stream(net::system_polled(), net::polled_stream_of(ends[0]), 1000);
  const auto some = bytes.first(std::min<std::size_t>(bytes.size(), 4096));
  PLAYHOUSE_ASSERT(write(ends[1], some.data(), some.size()) == static_cast<ssize_t>(some.size()));
  close(ends[1]);
  for (;;) {
    const Result<cluster::NodeMessage> message = stream.wait(cluster::Seconds{1});
    if (!message) break;
    PLAYHOUSE_ASSERT(message->body.size() <= 1000);
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto bytes = std::as_bytes(std::span(data, size));
  read_messages(bytes);
  if (const Result<cluster::Step> step = cluster::decode_step(bytes); step) {
    std::vector<std::byte> again;
    cluster::encode(*step, again);
    const Result<cluster::Step> same = cluster::decode_step(again);
    PLAYHOUSE_ASSERT(same.ok() && same->changes.size() == step->changes.size());
  }
  static_cast<void>(cluster::why_not_joined(bytes));
  const std::string_view token(reinterpret_cast<const char*>(data), size);
  PLAYHOUSE_ASSERT(cluster::why_not_joined(cluster::hello(token), token).empty());
  static config::MemoryFiles files({}, {});
  static const Result<scene::SceneDesc> scene = scene::load_world_text(kWorld, "fuzz.world", files);
  PLAYHOUSE_ASSERT(scene.ok());
  world::World world(*scene, 1);
  const std::vector<world::KindRow> rows{{{0}}, {{1}}};
  for (const scene::ModelKind kind :
       {scene::ModelKind::kRanger, scene::ModelKind::kFiducial, scene::ModelKind::kBlobfinder,
        scene::ModelKind::kCamera, scene::ModelKind::kDetector}) {
    Unpacker in(bytes);
    if (!world::unpack_sensed(world, kind, rows, in)) continue;
    std::vector<std::byte> again;
    world::pack_sensed(world, kind, rows, again);
    Unpacker twice(again);
    PLAYHOUSE_ASSERT(world::unpack_sensed(world, kind, rows, twice) && twice.at_end());
  }
  return 0;
}
