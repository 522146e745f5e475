#include "playhouse/cluster/head.h"

#include <arpa/inet.h>
#include <fmt/format.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <utility>

#include "playhouse/base/in_quotes.h"
#include "playhouse/base/limits.h"
#include "playhouse/base/log.h"
#include "playhouse/base/packing.h"
#include "playhouse/cluster/hello.h"
#include "playhouse/record/whole_state.h"
#include "playhouse/world/saved_run.h"

namespace playhouse::cluster {
namespace {

using Clock = std::chrono::steady_clock;

/// Ticks between two checks. One costs the hashes of the world, and a share that is computed twice.
constexpr std::uint64_t kCheckTicks = 100;

constexpr int kPollMilliseconds = 50;        // between looks at stop()
constexpr std::chrono::minutes kMaking{10};  // for a node to make its engine
constexpr Seconds kLastMessage{1};           // for a last message

}  // namespace

Head::Head(std::unique_ptr<world::Engine> engine, scene::SourceFiles sources, Options options,
           std::function<void(const Error&)> fail)
    : engine_(std::move(engine)),
      sources_(std::move(sources)),
      options_(std::move(options)),
      fail_(std::move(fail)) {}

Head::~Head() {
  for (const auto& node : nodes_) static_cast<void>(node->stream.send(Type::kEnd, {}, kLastMessage));
  for (Pending& pending : pending_) static_cast<void>(pending.stream.send(Type::kEnd, {}, Seconds{0}));
  if (listener_ >= 0) ::close(listener_);
}

Result<std::uint16_t> Head::listen() {
  const auto failed = [&](int code) {
    return Error{fmt::format("{}:{}", options_.bind, options_.port),
                 reason(code) + "; --cluster takes another port"};
  };
  sockaddr_storage address{};
  auto* const v4 = reinterpret_cast<sockaddr_in*>(&address);
  auto* const v6 = reinterpret_cast<sockaddr_in6*>(&address);
  const bool is_v6 = inet_pton(AF_INET6, options_.bind.c_str(), &v6->sin6_addr) == 1;
  if (!is_v6 && inet_pton(AF_INET, options_.bind.c_str(), &v4->sin_addr) != 1) return failed(EADDRNOTAVAIL);
  address.ss_family = is_v6 ? AF_INET6 : AF_INET;
  (is_v6 ? v6->sin6_port : v4->sin_port) = htons(options_.port);
  listener_ = socket(address.ss_family, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0);
  const int on = 1;
  setsockopt(listener_, SOL_SOCKET, SO_REUSEADDR, &on, sizeof on);
  auto* const any = reinterpret_cast<sockaddr*>(&address);
  socklen_t size = is_v6 ? sizeof *v6 : sizeof *v4;
  if (listener_ < 0 || bind(listener_, any, size) != 0 || ::listen(listener_, SOMAXCONN) != 0 ||
      getsockname(listener_, any, &size) != 0)
    return failed(errno);
  return ntohs(is_v6 ? v6->sin6_port : v4->sin_port);
}

void Head::accept_all() {
  for (;;) {
    const int socket = accept4(listener_, nullptr, nullptr, SOCK_CLOEXEC);
    if (socket < 0) return;
    Stream stream(socket, limits::kClusterHelloBytes);
    if (pending_.size() >= limits::kClusterNodes) continue;  // closes it
    std::string name = stream.peer();
    pending_.push_back({std::move(stream), std::move(name), Clock::now()});
  }
}

/// Goes on with those that want to join; none of them delays a tick.
void Head::admit() {
  accept_all();
  for (auto pending = pending_.begin(); pending != pending_.end();) {
    const auto next = std::next(pending);
    if (!negotiate(*pending)) pending_.erase(pending);
    pending = next;
  }
}

bool Head::negotiate(Pending& pending) {
  const auto end = [&](const std::string& why) {
    log::warn("cluster: {}: {}", pending.name, why);
    return false;
  };
  const Result<void> received = pending.stream.receive();
  const Result<std::optional<Message>> message = pending.stream.next();
  if (!message) return end(message.error().text);
  if (!*message) {
    if (!received) return end(received.error().text);
    const Result<bool> sent = pending.stream.flush();
    if (!sent) return end(sent.error().text);
    const auto patience = pending.has_world ? Clock::duration(kMaking)
                                            : std::chrono::duration_cast<Clock::duration>(options_.patience);
    return Clock::now() - pending.since < patience || end("is silent");
  }
  const Message& said = **message;
  if (said.type == Type::kRefusal) {
    Unpacker in(said.body);
    return end("cannot join: " + escaped(in.text()));
  }
  const auto refuse = [&](const std::string& why) {
    Bytes body;
    Packer(body).text(why);
    static_cast<void>(pending.stream.send(Type::kRefusal, {body}, kLastMessage));
    return end("cannot join: " + why);
  };
  if (!pending.has_world) {
    if (said.type != Type::kHello) return end("does not speak the protocol of clusters");
    if (const std::string why = why_not_joined(said.body); !why.empty()) return refuse(why);
    const world::World& world = engine_->world();
    if (world_.empty()) world_ = world::encode(world::SavedRun{sources_, world.engine, world.seed(), {}});
    pending.stream.queue(Type::kWorld, world_);
    pending.has_world = true;
    return true;
  }
  if (said.type != Type::kReady) return end("does not speak the protocol of clusters");
  if (nodes_.size() + joining_.size() >= limits::kClusterNodes)
    return refuse(fmt::format("there are {} nodes, the most", limits::kClusterNodes));
  join(pending);
  return false;
}

void Head::join(Pending& pending) {
  pending.stream.accept_up_to(limits::kClusterMessageBytes);
  auto node = std::make_unique<Node>(Node{std::move(pending.stream), pending.name});
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
    std::vector<pollfd> entries{{listener_, POLLIN, 0}};
    for (const Pending& pending : pending_) entries.push_back({pending.stream.socket(), POLLIN, 0});
    poll(entries.data(), entries.size(), kPollMilliseconds);
  }
}

void Head::before_changes(const world::World& world) {
  if (nodes_.empty() || before_) return;
  before_.emplace();
  if (const Result<void> saved = record::save_whole(world, *before_); !saved) lose_all(saved.error().line());
}

/// All changes since the last tick as one.
Result<Bytes> Head::changes() {
  if (!before_) return Bytes();
  Bytes now;
  if (const Result<void> saved = record::save_whole(engine_->world(), now); !saved) return saved.error();
  return now == *before_ ? Bytes() : record::difference(*before_, now);
}

void Head::lose_all(const std::string& why) {
  for (const auto& node : nodes_) lose(*node, why);
  drop_lost();
}

void Head::step() {
  wait_for_nodes();
  admit();
  if (!nodes_.empty() || !joining_.empty()) send_steps();
  before_.reset();
  engine_->divide(nodes_.empty() ? nullptr : this);
  engine_->step();
  drop_lost();
}

void Head::send_steps() {
  Result<Bytes> changes = this->changes();
  if (!changes) {
    lose_all(changes.error().line());
    changes = Bytes();
  }
  Bytes state;
  if (!joining_.empty())
    if (const Result<void> saved = record::save_whole(engine_->world(), state); !saved) {
      for (const auto& node : joining_) lose(*node, saved.error().line());
      joining_.clear();
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
  for (std::size_t index = 0; index < nodes_.size(); ++index) {
    Node& node = *nodes_[index];
    Step step{share_of(index), check_, {}, {}};
    if (node.is_new) {
      step.state = state;
    } else {
      step.change = *changes;
    }
    Bytes body;
    encode(step, body);
    node.has_shared = false;
    const Result<void> sent = node.stream.send(Type::kStep, {body}, options_.patience);
    if (!sent) lose(node, sent.error().text);
  }
}

/// Results are passed on as they come, so that nodes take them while others still compute.
void Head::run(world::DividedWork& work) {
  Bytes own;
  work.compute({0, nodes_.size() + 1}, own);
  pass_on(0, own);
  gather(work);
  for (std::size_t index = 0; index < nodes_.size(); ++index) {
    if (nodes_[index]->has_shared) continue;
    own.clear();
    work.compute(share_of(index), own);
    pass_on(index + 1, own);
  }
}

/// Waits until each node has shared its results or is lost.
void Head::gather(world::DividedWork& work) {
  const auto deadline_from_now = [&] {
    return Clock::now() + std::chrono::duration_cast<Clock::duration>(options_.patience);
  };
  for (Clock::time_point deadline = deadline_from_now();;) {
    std::vector<pollfd> missing;
    for (std::size_t index = 0; index < nodes_.size(); ++index) {
      const Node& node = *nodes_[index];
      if (!node.lost && !node.has_shared) receive_share(work, index);
      if (!node.lost && !node.has_shared) missing.push_back({node.stream.socket(), POLLIN, 0});
    }
    if (missing.empty()) return;
    const int come = poll(missing.data(), missing.size(), kPollMilliseconds);
    if (come > 0) deadline = deadline_from_now();
    if (come == 0 && (stopped_ || Clock::now() >= deadline)) break;
  }
  for (const auto& node : nodes_)
    if (!node->has_shared)
      lose(*node, stopped_ ? "the run ends" : fmt::format("is silent for {:g} s", options_.patience.count()));
}

void Head::receive_share(world::DividedWork& work, std::size_t index) {
  Node& node = *nodes_[index];
  const Result<void> received = node.stream.receive();
  const Result<std::optional<Message>> message = node.stream.next();
  if (!message) return lose(node, message.error().text);
  if (*message && (*message)->type == Type::kShare) return take_share(work, index, (*message)->body);
  if (*message) return lose(node, "does not speak the protocol of clusters");
  if (!received) lose(node, received.error().text);
}

/// The results stay in the stream of this node, which nothing is sent to or received from meanwhile.
void Head::take_share(world::DividedWork& work, std::size_t index, std::span<const std::byte> body) {
  Node& node = *nodes_[index];
  Unpacker in(body);
  std::optional<Hashes> hashes;
  if (check_) hashes = Hashes{in.u64(), in.u64()};
  const std::span<const std::byte> results = in.bytes(in.left());
  if (!in.ok()) return fail(node, "its measurements are none");
  if (hashes && *hashes != hashes_) return fail(node, "its world is another one");
  if (is_verified(index)) {
    Bytes own;
    work.compute(share_of(index), own);
    if (!std::ranges::equal(own, results)) return fail(node, "its measurements are others");
  } else if (!work.take(share_of(index), results)) {
    return fail(node, "its measurements are none");
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
    Node& node = *nodes_[to];
    if (node.lost || to + 1 == share) continue;
    const Result<void> sent = node.stream.send(Type::kResults, {index, results}, options_.patience);
    if (!sent) lose(node, sent.error().text);
  }
}

void Head::lose(Node& node, const std::string& why) {
  if (node.lost) return;
  node.lost = true;
  log::warn("cluster: {} is lost: {}", node.name, why);
  Bytes body;
  Packer(body).text(why);
  static_cast<void>(node.stream.send(Type::kRefusal, {body}, Seconds{0}));
}

void Head::drop_lost() {
  std::erase_if(nodes_, [](const auto& node) { return node->lost; });
}

/// What this node has measured before may be wrong as well.
void Head::fail(Node& node, const std::string& what) {
  const world::World& world = engine_->world();
  const std::string why = fmt::format("at {:.1f} s {}", world.time(), what);
  if (!failed_)
    fail_({"cluster", fmt::format("{}: {}; the program and libraries of a node have to be those of the head",
                                  node.name, why)});
  failed_ = true;
  lose(node, why);
}

}  // namespace playhouse::cluster
