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

constexpr int kPollMilliseconds = 50;  // while it waits for nodes
constexpr Seconds kGoodbye{1};         // for a last message

}  // namespace

Head::Head(std::unique_ptr<world::Engine> engine, scene::SourceFiles sources, Options options,
           std::function<void(const Error&)> fail)
    : engine_(std::move(engine)),
      sources_(std::move(sources)),
      options_(std::move(options)),
      fail_(std::move(fail)) {}

Head::~Head() {
  for (const auto& node : nodes_) static_cast<void>(node->stream.send(Type::kEnd, {}, kGoodbye));
  for (Newcomer& newcomer : newcomers_) static_cast<void>(newcomer.stream.send(Type::kEnd, {}, kGoodbye));
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
    if (newcomers_.size() >= limits::kClusterNodes) continue;  // closes it
    std::string name = stream.peer();
    newcomers_.push_back({std::move(stream), std::move(name), Clock::now()});
  }
}

/// Goes on with those that want to join; none of them delays a tick.
void Head::admit() {
  accept_all();
  for (auto newcomer = newcomers_.begin(); newcomer != newcomers_.end();) {
    const auto next = std::next(newcomer);
    if (!greet(*newcomer)) newcomers_.erase(newcomer);
    newcomer = next;
  }
}

bool Head::greet(Newcomer& newcomer) {
  const auto end = [&](const std::string& why) {
    log::warn("cluster: {}: {}", newcomer.name, why);
    return false;
  };
  const Result<void> received = newcomer.stream.receive();
  const Result<std::optional<Message>> message = newcomer.stream.next();
  if (!message) return end(message.error().text);
  if (!*message) {
    if (!received) return end(received.error().text);
    const bool too_late = !newcomer.has_world && Clock::now() - newcomer.since > options_.patience;
    return !too_late || end("says nothing");
  }
  const Message& said = **message;
  if (said.type == Type::kRefusal) {
    Unpacker in(said.body);
    return end("cannot join: " + escaped(in.text()));
  }
  const auto refuse = [&](const std::string& why) {
    Bytes body;
    Packer(body).text(why);
    static_cast<void>(newcomer.stream.send(Type::kRefusal, {body}, kGoodbye));
    return end("cannot join: " + why);
  };
  if (!newcomer.has_world) {
    if (said.type != Type::kHello) return end("does not speak the protocol of clusters");
    if (const std::string why = why_not_joined(said.body); !why.empty()) return refuse(why);
    const world::World& world = engine_->world();
    const Bytes run = world::encode(world::SavedRun{sources_, world.engine, world.seed(), {}});
    if (const Result<void> sent = newcomer.stream.send(Type::kWorld, {run}, options_.patience); !sent)
      return end(sent.error().text);
    newcomer.has_world = true;
    return true;
  }
  if (said.type != Type::kReady) return end("does not speak the protocol of clusters");
  if (nodes_.size() + joining_.size() >= limits::kClusterNodes)
    return refuse(fmt::format("there are {} nodes, the most", limits::kClusterNodes));
  let_in(newcomer);
  return false;
}

void Head::let_in(Newcomer& newcomer) {
  newcomer.stream.accept_up_to(limits::kClusterMessageBytes);
  auto node = std::make_unique<Node>(Node{std::move(newcomer.stream), newcomer.name, {}});
  joining_.push_back(std::move(node));
}

void Head::wait_for_nodes() {
  if (started_) return;
  started_ = true;
  std::size_t told = SIZE_MAX;
  for (admit(); joining_.size() < options_.nodes && !stopped_; admit()) {
    if (told != joining_.size())
      log::info("waiting for nodes: {} of {} are there", joining_.size(), options_.nodes);
    told = joining_.size();
    std::vector<pollfd> entries{{listener_, POLLIN, 0}};
    for (const Newcomer& newcomer : newcomers_) entries.push_back({newcomer.stream.socket(), POLLIN, 0});
    poll(entries.data(), entries.size(), kPollMilliseconds);
  }
}

void Head::before_changes(const world::World& world) {
  before_.clear();
  if (nodes_.empty()) return;
  if (const Result<void> saved = record::save_whole(world, before_); !saved) {
    for (const auto& node : nodes_) lose(*node, saved.error().line());
    drop_lost();
  }
}

void Head::after_changes(const world::World& world) {
  if (nodes_.empty()) return;
  Bytes after;
  if (const Result<void> saved = record::save_whole(world, after); !saved) {
    for (const auto& node : nodes_) lose(*node, saved.error().line());
    drop_lost();
  } else if (after != before_) {
    changes_.push_back(record::difference(before_, after));
  }
}

void Head::step() {
  wait_for_nodes();
  admit();
  if (!nodes_.empty() || !joining_.empty()) send_steps();
  changes_.clear();
  engine_->divide(nodes_.empty() ? nullptr : this);
  engine_->step();
  drop_lost();
}

void Head::send_steps() {
  check_ = !failed_ && ticks_++ % kCheckTicks == 0;
  if (check_) hashes_ = {engine_->world().hash(), engine_->world().sensed_hash()};
  Bytes state;
  if (!joining_.empty()) {
    if (const Result<void> saved = record::save_whole(engine_->world(), state); !saved) {
      for (const auto& node : joining_) lose(*node, saved.error().line());
      joining_.clear();
    }
  }
  const std::size_t old = nodes_.size();
  for (auto& node : joining_) {
    log::info("cluster: {} takes part from {:.1f} s on", node->name, engine_->world().time());
    nodes_.push_back(std::move(node));
  }
  joining_.clear();
  Step step{{0, nodes_.size() + 1}, check_, {}, {}};
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    step.share.index = i + 1;
    step.state = i < old ? std::span<const std::byte>() : state;
    step.changes.clear();
    if (i < old) step.changes.assign(changes_.begin(), changes_.end());
    Bytes body;
    encode(step, body);
    Node& node = *nodes_[i];
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
  const Clock::time_point deadline =
      Clock::now() + std::chrono::duration_cast<Clock::duration>(options_.patience);
  for (;;) {
    std::vector<pollfd> missing;
    for (std::size_t index = 0; index < nodes_.size(); ++index) {
      const Node& node = *nodes_[index];
      if (!node.lost && !node.has_shared) hear(work, index);
      if (!node.lost && !node.has_shared) missing.push_back({node.stream.socket(), POLLIN, 0});
    }
    if (missing.empty()) return;
    const auto left = std::chrono::ceil<std::chrono::milliseconds>(deadline - Clock::now()).count();
    if (left <= 0) break;
    poll(missing.data(), missing.size(), static_cast<int>(left));
  }
  for (const auto& node : nodes_)
    if (!node->has_shared) lose(*node, fmt::format("is silent for {:g} s", options_.patience.count()));
}

void Head::hear(world::DividedWork& work, std::size_t index) {
  Node& node = *nodes_[index];
  const Result<void> received = node.stream.receive();
  const Result<std::optional<Message>> message = node.stream.next();
  if (!message) return lose(node, message.error().text);
  if (*message && (*message)->type == Type::kShare) return take_share(work, index, (*message)->body);
  if (*message) return lose(node, "does not speak the protocol of clusters");
  if (!received) lose(node, received.error().text);
}

void Head::take_share(world::DividedWork& work, std::size_t index, std::span<const std::byte> body) {
  Node& node = *nodes_[index];
  Unpacker in(body);
  std::optional<Hashes> hashes;
  if (check_) hashes = Hashes{in.u64(), in.u64()};
  const std::span<const std::byte> results = in.bytes(in.left());
  node.results.assign(results.begin(), results.end());
  if (!in.ok()) return lose(node, "sent a share that is none");
  if (hashes && *hashes != hashes_) give_up(node, "its world is another one");
  if (!adopt(work, index)) return lose(node, "sent a share that is none");
  node.has_shared = true;
  pass_on(index + 1, node.results);
}

/// At a check computes the share of one of the nodes as well, and compares. False: its results are none.
bool Head::adopt(world::DividedWork& work, std::size_t index) {
  Node& node = *nodes_[index];
  if (!check_ || index != ticks_ / kCheckTicks % nodes_.size())
    return work.take(share_of(index), node.results);
  Bytes own;
  work.compute(share_of(index), own);
  if (own != node.results) give_up(node, "its measurements are others");
  node.results = std::move(own);
  return true;
}

/// To all that do not have them.
void Head::pass_on(std::size_t share, const Bytes& results) {
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

void Head::give_up(const Node& node, const std::string& what) {
  if (failed_) return;
  failed_ = true;
  const world::World& world = engine_->world();
  fail_({"cluster", fmt::format("{} at {:.1f} s: {}; nodes want the same program and libraries", node.name,
                                world.time(), what)});
}

}  // namespace playhouse::cluster
