#include "playhouse/cluster/node.h"

#include <fmt/format.h>

#include <chrono>
#include <memory>
#include <optional>
#include <thread>
#include <utility>

#include "playhouse/app/commands/commands.h"
#include "playhouse/app/commands/device_name.h"
#include "playhouse/app/world_opener.h"
#include "playhouse/base/fail.h"
#include "playhouse/base/in_quotes.h"
#include "playhouse/base/log.h"
#include "playhouse/net/polled/system_polled.h"

namespace playhouse::app {
namespace {

using cluster::Seconds;

constexpr std::chrono::milliseconds kRetry{100};
constexpr Seconds kWorldArrives{60};  // for a run that has begun to send its world

/// Connects, also if the run begins within `patience` only: jobs of a cluster start in any order.
Result<cluster::MessageStream> connect(const client::Address& head, Seconds patience) {
  const auto start = std::chrono::steady_clock::now();
  for (bool told = false;; told = true) {
    const Seconds left = patience - (std::chrono::steady_clock::now() - start);
    Result<cluster::MessageStream> stream = cluster::MessageStream::connect(
        net::system_polled(), head.host, head.port, std::max(left, Seconds{1}));
    if (stream || left <= Seconds{0}) return stream;
    if (!told) log::info("waiting for a run at {}:{}", head.host, head.port);
    std::this_thread::sleep_for(kRetry);
  }
}

/// The run as this node has it.
class Replica {
 public:
  explicit Replica(const Running& running) : running_(running) {}

  Result<world::Engine*> make(world::SavedRun run) {
    running_.engine = run.engine;
    running_.seed = run.seed;
    Result<scene::SceneDesc> scene = scene_of(run.sources, std::nullopt, nullptr);
    if (!scene) return scene.error();
    scene_ = std::move(*scene);
    Result<std::unique_ptr<world::Engine>> engine =
        make_engine(scene_, running_, controllers::Libraries::LibraryUse::kLoad, &warn);
    if (!engine) return engine.error();
    engine_ = std::move(*engine);
    log::info("joins the run of {}, engine {}, {} robots", escaped(run.sources.path), run.engine,
              count_robots(engine_->world()));
    return engine_.get();
  }

 private:
  Running running_;
  scene::SceneDesc scene_;
  std::unique_ptr<world::Engine> engine_;
};

}  // namespace

int node(const NodeOptions& options) {
  const Result<client::Address> head = parse_server(options.head, kClusterPort);
  if (!head) return fail(head.error(), kUsage);
  const auto failed = [&](const Error& error) {
    return fail({fmt::format("{}:{}", head->host, head->port), error.text});
  };
  Result<cluster::MessageStream> stream = connect(*head, Seconds{options.wait});
  if (!stream) return failed(stream.error());
  Replica replica(options.running);
  cluster::Node node(std::move(*stream), options.token, Seconds{options.wait} + kWorldArrives);
  const Result<cluster::Node::Summary> done =
      node.run([&](world::SavedRun run) { return replica.make(std::move(run)); });
  if (!done) return failed(done.error());
  log::info("the run has ended: a share of {} ticks, {:.1f} s to {:.1f} s", done->ticks, done->from,
            done->to);
  return kDone;
}

}  // namespace playhouse::app
