#include "playhouse/cluster/head.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "playhouse/base/in_quotes.h"
#include "playhouse/base/limits.h"
#include "playhouse/base/log.h"
#include "playhouse/base/packing.h"
#include "playhouse/cluster/hello.h"
#include "playhouse/net/fair_share.h"
#include "playhouse/world/changes/packed_change.h"
#include "playhouse/world/saving/saved_run.h"
#include "playhouse/world/saving/whole_state.h"

namespace playhouse::cluster {
namespace {

/// Ticks between two checks. One costs the hashes of the world, and a share that is computed twice.
constexpr std::uint64_t kCheckTicks = 100;

constexpr double kLook = 0.05;                  // s between looks at stop()
constexpr std::chrono::minutes kMaking{10};     // for a node to make its engine
constexpr Seconds kLastMessages{1};             // for the last messages to all
constexpr std::size_t kShareBytes = 16 << 20;   // of a share of any world
constexpr std::size_t kChangesBytes = 1 << 20;  // of changes between two ticks; above: a state
constexpr double kSlowerNode = 10;              // times the head's own share: of a node that computes slower

}  // namespace

Head::Head(net::PolledNetwork& network, std::unique_ptr<world::Engine> engine, config::SourceFiles sources,
           HeadOptions options, std::function<void(const Error&)> fail)
    : network_(network),
      engine_(std::move(engine)),
      sources_(std::move(sources)),
      options_(std::move(options)),
      fail_(std::move(fail)) {}

Head::~Head() {
  const Until end = until(network_.now(), kLastMessages);
  for (const auto& node : nodes_) static_cast<void>(node->stream.send(NodeMessageType::kEnd, {}, end));
  for (Pending& pending : pending_)
    static_cast<void>(pending.stream.send(NodeMessageType::kEnd, {}, Seconds{0}));
}

Result<std::uint16_t> Head::listen() {
  Result<std::unique_ptr<net::PolledListener>> listener = network_.listen(options_.bind, options_.port);
  if (!listener)
    return Error{fmt::format("{}:{}", options_.bind, options_.port),
                 listener.error().text + "; --cluster takes another port"};
  listener_ = std::move(*listener);
  return listener_->port();
}

/// When there is no room, the oldest of the network with the most gives way.
void Head::accept_all() {
  for (std::size_t accepted = 0; accepted < limits::kClusterNodes; ++accepted) {
    std::unique_ptr<net::PolledStream> stream = listener_ ? listener_->accept() : nullptr;
    if (!stream) return;
    std::string name = stream->peer(), network = net::network_of(name);
    if (pending_.size() >= limits::kClusterNodes) {
      std::vector<net::Holder> holders;
      for (const Pending& pending : pending_) holders.push_back({pending.network, pending.since});
      const auto place = static_cast<std::ptrdiff_t>(net::gives_way(holders));
      pending_.erase(std::next(pending_.begin(), place));
    }
    pending_.push_back({MessageStream(network_, std::move(stream), limits::kClusterHelloBytes),
                        std::move(name), std::move(network), network_.now()});
  }
}

/// Goes on with those that want to join; none of them delays a tick.
void Head::admit() {
  accept_all();
  std::size_t room = limits::kClusterWorldBytes;
  for (auto pending = pending_.begin(); pending != pending_.end();) {
    const auto next = std::next(pending);
    if (!negotiate(*pending, room)) pending_.erase(pending);
    pending = next;
  }
}

bool Head::negotiate(Pending& pending, std::size_t& room) {
  const auto end = [&](const std::string& why) {
    log::warn("cluster: {}: {}", pending.name, why);
    return false;
  };
  const Result<void> received = pending.stream.receive();
  const Result<std::optional<NodeMessage>> message = pending.stream.next();
  if (!message) return end(message.error().text);
  if (!*message) {
    if (!received) return end(received.error().text);
    const Result<std::size_t> sent = pending.stream.flush(room);
    if (!sent) return end(sent.error().text);
    room -= *sent;
    const Seconds patience = pending.has_world ? Seconds(kMaking) : options_.patience;
    return since(pending.since) < patience || end("is silent");
  }
  const NodeMessage& said = **message;
  if (said.type == NodeMessageType::kRefusal) {
    Unpacker in(said.body);
    return end("cannot join: " + escaped(in.text()));
  }
  if (!pending.has_world && said.type == NodeMessageType::kHello) return welcome(pending, said.body);
  if (!pending.has_world || said.type != NodeMessageType::kReady)
    return end("does not speak the protocol of clusters");
  if (nodes_.size() + joining_.size() >= limits::kClusterNodes)
    return refuse(pending, fmt::format("there are {} nodes, the most", limits::kClusterNodes));
  join(pending);
  return false;
}

bool Head::welcome(Pending& pending, std::span<const std::byte> hello) {
  if (const std::string why = why_not_joined(hello, options_.token); !why.empty())
    return refuse(pending, why);
  if (const int left = quarantine_of(pending.network); left > 0)
    return refuse(pending, fmt::format("a node at its address was silent: in {} s it can", left));
  pending.stream.queue(NodeMessageType::kWorld, world_message());
  pending.has_world = true;
  return true;
}

bool Head::refuse(Pending& pending, const std::string& why) {
  Bytes body;
  Packer(body).text(why);
  static_cast<void>(pending.stream.send(NodeMessageType::kRefusal, {body}, Seconds{0}));
  log::warn("cluster: {}: cannot join: {}", pending.name, why);
  return false;
}

/// Encoded once, for all nodes.
const std::shared_ptr<const Bytes>& Head::world_message() {
  const world::World& world = engine_->world();
  if (world_ == nullptr)
    world_ = std::make_shared<const Bytes>(
        world::encode(world::SavedRun{sources_, world.engine, world.seed(), {}}));
  return world_;
}

/// Seconds until a node of this network may join, after one that was silent; 0: at once.
int Head::quarantine_of(const std::string& network) const {
  const auto silenced = silenced_.find(network);
  if (silenced == silenced_.end()) return 0;
  const Seconds left = Seconds{limits::kClusterQuarantineSeconds} - since(silenced->second);
  return std::max(0, static_cast<int>(std::ceil(left.count())));
}

void Head::join(Pending& pending) {
  auto node = std::make_unique<NodeLink>(NodeLink{std::move(pending.stream), pending.name});
  joining_.push_back(std::move(node));
}

void Head::wait_for_nodes() {
  if (started_) return;
  started_ = true;
  std::size_t told = SIZE_MAX;
  for (admit(); joining_.size() < options_.nodes && !stopped_; admit()) {
    std::erase_if(joining_, [](const auto& node) { return !node->stream.receive(); });
    if (told != joining_.size())
      log::info("waiting for nodes: {} of {} are there", joining_.size(), options_.nodes);
    told = joining_.size();
    std::vector<net::PollWish> wishes;
    for (const Pending& pending : pending_) wishes.push_back(pending.stream.wish());
    network_.wait(wishes, listener_.get(), network_.now() + kLook);
  }
}

void Head::changed(const world::World&, std::span<const world::Change> changes) {
  if (nodes_.empty()) return;
  for (const world::Change& change : changes) {
    if (sends_state_) return;
    sends_state_ = std::holds_alternative<world::changes::Load>(change) || changes_.size() > kChangesBytes;
    if (!sends_state_) world::pack(change, changes_);
  }
}

void Head::step() {
  wait_for_nodes();
  admit();
  if (!nodes_.empty() || !joining_.empty()) send_steps();
  changes_.clear();
  sends_state_ = false;
  engine_->divide(nodes_.empty() ? nullptr : this);
  engine_->step();
  drop_lost();
}

void Head::step_alone() {
  engine_->divide(nullptr);
  engine_->step();
}

bool Head::needs_state() const {
  return !joining_.empty() || (sends_state_ && !nodes_.empty());
}

void Head::send_steps() {
  Bytes state;
  if (needs_state())
    if (const Result<void> saved = world::save_whole(engine_->world(), state); !saved) {
      for (const auto& node : joining_) lose(*node, saved.error().line());
      joining_.clear();
      if (sends_state_)
        for (const auto& node : nodes_) lose(*node, saved.error().line());
    }
  check_ = !failed_ && (!joining_.empty() || ticks_ % kCheckTicks == 0);
  ++ticks_;
  if (check_) hashes_ = {engine_->world().hash(), engine_->world().sensed_hash()};
  for (const auto& node : nodes_) node->is_new = false;
  for (auto& node : joining_) {
    log::info("cluster: {} takes part from {:.1f} s on", node->name, engine_->world().time());
    nodes_.push_back(std::move(node));
  }
  joining_.clear();
  step_bytes_ = std::max(state.size(), changes_.size());
  if (check_ || step_bytes_ > 0) bound_shares();
  const Until end = until(network_.now(), options_.patience, nodes_.size() * step_bytes_, &stopped_);
  for (std::size_t index = 0; index < nodes_.size(); ++index) {
    NodeLink& node = *nodes_[index];
    if (node.lost) continue;
    Step step{share_of(index), check_, {}, {}};
    if (node.is_new || sends_state_) {
      step.state = state;
    } else {
      step.changes = changes_;
    }
    Bytes body;
    encode(step, body);
    node.has_shared = false;
    const Result<void> sent = node.stream.send(NodeMessageType::kStep, {body}, end);
    if (!sent) lose(node, sent.error().text);
  }
}

/// A share is smaller than the measurements of the world, which are part of it.
void Head::bound_shares() {
  const std::size_t most = std::min(limits::kClusterMessageBytes, kShareBytes + 2 * engine_->world().bytes());
  for (const auto& node : nodes_) node->stream.accept_up_to(most);
}

/// Results are passed on as they come, so that nodes take them while others still compute.
void Head::run(world::DividedWork& work) {
  Bytes own;
  const double start = network_.now();
  work.compute({0, nodes_.size() + 1}, own);
  expect_shares(since(start), own.size());
  pass_on(0, own);
  gather(work);
  for (std::size_t index = 0; index < nodes_.size(); ++index) {
    if (nodes_[index]->has_shared) continue;
    own.clear();
    work.compute(share_of(index), own);
    pass_on(index + 1, own);
  }
}

/// One end for the exchange with all nodes, whatever they send meanwhile: a node holds no tick for longer.
/// The head's own share took `own` and has so many bytes; what a node reads before is counted as well.
void Head::expect_shares(Seconds own, std::size_t bytes) {
  const std::size_t exchanged = bytes * nodes_.size() * nodes_.size();
  end_ = until(network_.now(), options_.patience + own * kSlowerNode, exchanged + step_bytes_, &stopped_);
}

/// Waits until each node has shared its results or is lost.
void Head::gather(world::DividedWork& work) {
  for (;;) {
    std::vector<net::PollWish> missing;
    for (std::size_t index = 0; index < nodes_.size(); ++index) {
      const NodeLink& node = *nodes_[index];
      if (!node.lost && !node.has_shared) receive_share(work, index);
      if (!node.lost && !node.has_shared) missing.push_back({node.stream.wish()});
    }
    if (missing.empty()) return;
    if (network_.now() >= end_.deadline) break;
    if (!network_.wait(missing, nullptr, std::min(end_.deadline, network_.now() + kLook)) && stopped_) break;
  }
  for (const auto& node : nodes_) {
    if (node->has_shared || node->lost) continue;
    if (!stopped_) silenced_[net::network_of(node->name)] = network_.now();
    lose(*node, stopped_ ? "the run ends" : "has not shared its results in time");
  }
}

void Head::receive_share(world::DividedWork& work, std::size_t index) {
  NodeLink& node = *nodes_[index];
  const Result<void> received = node.stream.receive();
  const Result<std::optional<NodeMessage>> message = node.stream.next();
  if (!message) return lose(node, message.error().text);
  if (*message && (*message)->type == NodeMessageType::kShare)
    return take_share(work, index, (*message)->body);
  if (*message) return lose(node, "does not speak the protocol of clusters");
  if (!received) lose(node, received.error().text);
}

/// The results stay in the stream of this node, which nothing is sent to or received from meanwhile.
void Head::take_share(world::DividedWork& work, std::size_t index, std::span<const std::byte> body) {
  NodeLink& node = *nodes_[index];
  Unpacker in(body);
  std::optional<Hashes> hashes;
  if (check_) hashes = Hashes{in.u64(), in.u64()};
  const std::span<const std::byte> results = in.bytes(in.left());
  if (!in.ok()) return fail(node, "it sent invalid measurements");
  if (hashes && *hashes != hashes_) return fail(node, "its world differs");
  if (is_verified(index)) {
    Bytes own;
    work.compute(share_of(index), own);
    if (!std::ranges::equal(own, results)) return fail(node, "its measurements differ");
  } else if (!work.take(share_of(index), results)) {
    return fail(node, "it sent invalid measurements");
  }
  node.has_shared = true;
  pass_on(index + 1, results);
}

/// At a check, of nodes that are new and one of the others: their shares are computed here as well.
bool Head::is_verified(std::size_t index) const {
  return check_ && (nodes_[index]->is_new || index == ticks_ / kCheckTicks % nodes_.size());
}

/// To all that do not have them.
void Head::pass_on(std::size_t share, std::span<const std::byte> results) {
  Bytes index;
  Packer(index).varint(share);
  for (std::size_t to = 0; to < nodes_.size(); ++to) {
    NodeLink& node = *nodes_[to];
    if (node.lost || to + 1 == share) continue;
    const Result<void> sent = node.stream.send(NodeMessageType::kResults, {index, results}, end_);
    if (!sent) lose(node, sent.error().text);
  }
}

void Head::lose(NodeLink& node, const std::string& why) {
  if (node.lost) return;
  node.lost = true;
  log::warn("cluster: {} is lost: {}", node.name, why);
  Bytes body;
  Packer(body).text(why);
  static_cast<void>(node.stream.send(NodeMessageType::kRefusal, {body}, Seconds{0}));
}

void Head::drop_lost() {
  std::erase_if(nodes_, [](const auto& node) { return node->lost; });
}

/// What this node has measured before may be wrong as well.
void Head::fail(NodeLink& node, const std::string& what) {
  const world::World& world = engine_->world();
  const std::string why = fmt::format("at {:.1f} s {}", world.time(), what);
  if (node.is_new) return lose(node, why);  // it was verified before anything of it was used
  if (!failed_)
    fail_({"cluster", fmt::format("{}: {}; the program and libraries of a node have to be those of the head",
                                  node.name, why)});
  failed_ = true;
  lose(node, why);
}

}  // namespace playhouse::cluster
