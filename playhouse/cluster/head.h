#pragma once

/// Head: the engine of a run whose work is shared with other nodes (docs/cluster.md, docs/adr/0022). All
/// have the whole world. Before each tick the head sends the changes since the last one, as recordings
/// have them; in the tick each node computes its share (world/division.h), and the head passes the results
/// on. The share of a node that is lost is computed here. Thread: tick.

#include <atomic>
#include <functional>
#include <list>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "playhouse/base/limits.h"
#include "playhouse/cluster/step.h"
#include "playhouse/cluster/stream.h"
#include "playhouse/config/text/source_text.h"
#include "playhouse/run/follower.h"
#include "playhouse/world/engine.h"

namespace playhouse::cluster {

class Head final : public world::Engine, public run::Follower, private world::Division {
 public:
  struct HeadOptions {
    std::string bind = "127.0.0.1";
    std::uint16_t port = 0;  // 0: any free one
    std::size_t nodes = 0;   // to wait for before the first tick
    std::string token = {};  // that nodes have to have; empty: whoever connects
    Seconds patience{
        limits::kClusterSilentSeconds};  // with all nodes in a tick, and with a silent connection
  };
  /// The world of `engine` is that of `sources`. `fail` is called, on the tick thread, when
  /// a node that took part is found to compute something else: the run is worthless from then on. One that
  /// does so in its first tick is refused, and the run goes on.
  Head(net::PolledNetwork& network, std::unique_ptr<world::Engine> engine, config::SourceFiles sources,
       HeadOptions options, std::function<void(const Error&)> fail);
  ~Head() override;

  /// Opens the port, and returns it.
  Result<std::uint16_t> listen();
  /// Makes step() no longer wait for nodes. Any thread, signal handlers included.
  void stop() { stopped_ = true; }
  /// Nodes that take part, the head not counted.
  std::size_t nodes() const { return nodes_.size(); }

  void step() override;
  void step_alone() override;
  world::World& world() override { return engine_->world(); }
  world::Workers& workers() override { return engine_->workers(); }
  std::uint64_t rays() const override { return engine_->rays(); }
  world::PhysicsShapes physics_shapes() override { return engine_->physics_shapes(); }

  void changed(const world::World& world, std::span<const world::Change> changes) override;

 private:
  /// A connection that does not take part yet.
  struct Pending {
    MessageStream stream;
    std::string name, network;
    double since = 0;        // s
    bool has_world = false;  // or is being sent it
  };
  struct NodeLink {
    MessageStream stream;
    std::string name;    // of the peer
    bool is_new = true;  // in its first tick
    bool lost = false, has_shared = false;
  };

  void run(world::DividedWork& work) override;

  void admit();
  void accept_all();
  /// False: the connection is over. `room`: bytes that may still be sent before the next tick.
  bool negotiate(Pending& pending, std::size_t& room);
  bool welcome(Pending& pending, std::span<const std::byte> hello);
  bool refuse(Pending& pending, const std::string& why);
  const std::shared_ptr<const Bytes>& world_message();
  int quarantine_of(const std::string& network) const;
  void join(Pending& pending);
  void wait_for_nodes();
  Seconds since(double start) const { return Seconds(network_.now() - start); }
  bool needs_state() const;
  void send_steps();
  void gather(world::DividedWork& work);
  void receive_share(world::DividedWork& work, std::size_t index);
  void take_share(world::DividedWork& work, std::size_t index, std::span<const std::byte> body);
  bool is_verified(std::size_t index) const;
  void pass_on(std::size_t share, std::span<const std::byte> results);
  world::Share share_of(std::size_t index) const { return {index + 1, nodes_.size() + 1}; }
  void expect_shares(Seconds own, std::size_t bytes);
  void bound_shares();
  void lose(NodeLink& node, const std::string& why);
  void drop_lost();
  void fail(NodeLink& node, const std::string& what);

  net::PolledNetwork& network_;
  std::unique_ptr<world::Engine> engine_;
  config::SourceFiles sources_;
  HeadOptions options_;
  std::function<void(const Error&)> fail_;
  std::unique_ptr<net::PolledListener> listener_;
  std::atomic<bool> stopped_ = false;
  bool started_ = false, failed_ = false;

  std::list<Pending> pending_;
  std::vector<std::unique_ptr<NodeLink>> nodes_, joining_;  // joining_ take part from the next tick on
  std::shared_ptr<const Bytes> world_;                      // the body of a message kWorld
  std::map<std::string, double> silenced_;  // networks of nodes that were silent, and when [s]
  Bytes changes_;                           // since the last tick, packed; none are kept without nodes
  bool sends_state_ = false;                // instead of the changes since the last tick
  std::uint64_t ticks_ = 0;                 // with nodes
  bool check_ = false;                      // in this tick
  std::size_t step_bytes_ = 0;              // most that a node has to read before it computes this tick
  Until end_{};                             // of the exchange of results in this tick
  Hashes hashes_;                           // at the check
};

}  // namespace playhouse::cluster
