#include "playhouse/net/simulated.h"

#include <algorithm>
#include <iterator>

namespace playhouse::net {

/// A byte queue with bulk moves, unlike a deque's bytewise ones.
class ByteQueue {
 public:
  bool empty() const { return begin_ == bytes_.size(); }
  std::size_t size() const { return bytes_.size() - begin_; }
  void append(std::span<const std::byte> bytes) { bytes_.insert(bytes_.end(), bytes.begin(), bytes.end()); }
  std::span<const std::byte> front(std::size_t most) const {
    return std::span(bytes_).subspan(begin_, std::min(most, size()));
  }
  void pop(std::size_t count) {
    begin_ += count;
    if (2 * begin_ < bytes_.size()) return;
    bytes_.erase(bytes_.begin(), bytes_.begin() + static_cast<std::ptrdiff_t>(begin_));
    begin_ = 0;
  }
  void clear() {
    bytes_.clear();
    begin_ = 0;
  }

 private:
  std::vector<std::byte> bytes_;
  std::size_t begin_ = 0;  // bytes before were consumed
};

/// Both directions of a connection.
struct SimulatedLink {
  std::string name;
  ConnectionEvents* events = nullptr;
  ByteQueue to_server;          // sent by the peer, not delivered
  ByteQueue in_flight;          // sent by the server, not accepted by the "system"
  ByteQueue window;             // accepted, not read by the peer
  std::vector<std::byte> read;  // read by the peer, for take()
  bool finished = false, vanished = false, stalled = false, paused = false;
  bool told_lost = false, told_closed = false;
  bool draining = false;  // `drained` is pending
  bool flushing = false;  // after close_after_flush
  bool closed = false;    // the server's end was destroyed
};

/// The client's end of a connection made by Network::connect.
struct SimulatedEnd {
  std::shared_ptr<SimulatedLink> link;
  ConnectionEvents* events = nullptr;
  bool draining = false;     // `drained` is pending
  bool told_closed = false;  // closed() was called
  bool gone = false;
};

namespace {

class SimulatedConnection final : public Connection {
 public:
  explicit SimulatedConnection(std::shared_ptr<SimulatedLink> link) : link_(std::move(link)) {}
  ~SimulatedConnection() override {
    link_->events = nullptr;
    if (link_->flushing) return;
    link_->in_flight.clear();
    link_->closed = true;
  }
  void start(ConnectionEvents& events) override { link_->events = &events; }
  void send(std::span<const SharedBytes> parts) override {
    if (link_->vanished) return;
    for (const SharedBytes& part : parts) {
      link_->in_flight.append(*part);
    }
    link_->draining = true;
  }
  std::size_t in_flight_bytes() const override { return link_->in_flight.size(); }
  void pause() override { link_->paused = true; }
  void resume() override { link_->paused = false; }
  void close_after_flush() override {
    link_->events = nullptr;
    link_->flushing = true;
  }
  const std::string& peer() const override { return link_->name; }

 private:
  std::shared_ptr<SimulatedLink> link_;
};

/// Input arrives in pieces already; output is in flight until the server has read it.
class SimulatedClient final : public Connection {
 public:
  SimulatedClient(std::shared_ptr<SimulatedEnd> end, std::string peer)
      : end_(std::move(end)), peer_(std::move(peer)) {}
  ~SimulatedClient() override {
    end_->events = nullptr;
    end_->gone = true;
    SimulatedPeer(end_->link).finish();
  }
  void start(ConnectionEvents& events) override { end_->events = &events; }
  void send(std::span<const SharedBytes> parts) override {
    for (const SharedBytes& part : parts) SimulatedPeer(end_->link).send(*part);
    end_->draining = true;
  }
  std::size_t in_flight_bytes() const override { return end_->link->to_server.size(); }
  void pause() override { SimulatedPeer(end_->link).stall(); }
  void resume() override { SimulatedPeer(end_->link).read_on(); }
  void close_after_flush() override {
    end_->events = nullptr;
    SimulatedPeer(end_->link).finish();
  }
  const std::string& peer() const override { return peer_; }

 private:
  std::shared_ptr<SimulatedEnd> end_;
  std::string peer_;
};

struct SimulatedAttempt final : Attempt {
  std::shared_ptr<int> live = std::make_shared<int>(0);
};

class SimulatedListener final : public Listener {
 public:
  SimulatedListener(std::uint16_t port, std::shared_ptr<Network::Acceptor> acceptor)
      : port_(port), acceptor_(std::move(acceptor)) {}
  ~SimulatedListener() override { *acceptor_ = nullptr; }
  std::uint16_t port() const override { return port_; }

 private:
  std::uint16_t port_;
  std::shared_ptr<Network::Acceptor> acceptor_;  // shared with the network, which calls it
};

struct SimulatedTimer final : Timer {
  std::shared_ptr<int> live = std::make_shared<int>(0);
};

std::size_t move_front(ByteQueue& from, std::size_t most, ByteQueue& to) {
  const std::span<const std::byte> moved = from.front(most);
  to.append(moved);
  from.pop(moved.size());
  return moved.size();
}

}  // namespace

void SimulatedPeer::send(std::span<const std::byte> bytes) {
  if (link_->finished || link_->vanished) return;
  link_->to_server.append(bytes);
}
void SimulatedPeer::finish() {
  link_->finished = true;
}
void SimulatedPeer::vanish() {
  link_->to_server.clear();
  reset();
}
void SimulatedPeer::reset() {
  link_->vanished = true;
  link_->in_flight.clear();
}
void SimulatedPeer::stall() {
  link_->stalled = true;
}
void SimulatedPeer::read_on() {
  link_->stalled = false;
}
std::vector<std::byte> SimulatedPeer::take() {
  return std::exchange(link_->read, {});
}
bool SimulatedPeer::closed() const {
  return link_->closed && link_->in_flight.empty() && link_->window.empty();
}

SimulatedNetwork::~SimulatedNetwork() = default;

SimulatedPeer SimulatedNetwork::connect(std::uint16_t port, const std::string& address) {
  const auto found = ports_.find(port);
  PLAYHOUSE_ASSERT(found != ports_.end() && *found->second);
  auto link = std::make_shared<SimulatedLink>();
  link->name = address + ":" + std::to_string(++connections_);
  links_.push_back(link);
  post([acceptor = found->second, link] {
    if (*acceptor) (*acceptor)(std::make_unique<SimulatedConnection>(link));
  });
  return SimulatedPeer(link);
}

void SimulatedNetwork::post(Task task) {
  tasks_.push_back(std::move(task));
}

std::unique_ptr<Timer> SimulatedNetwork::after(double seconds, Task task) {
  auto timer = std::make_unique<SimulatedTimer>();
  alarms_.emplace(now_ + seconds, Alarm{timer->live, std::move(task)});
  return timer;
}

Result<std::unique_ptr<Listener>> SimulatedNetwork::listen(const std::string& bind, std::uint16_t port,
                                                           Acceptor acceptor) {
  if (port == 0) port = next_port_++;
  auto& entry = ports_[port];
  if (entry && *entry) return Error{bind + ":" + std::to_string(port), "cannot listen: port in use"};
  entry = std::make_shared<Acceptor>(std::move(acceptor));
  return std::unique_ptr<Listener>(std::make_unique<SimulatedListener>(port, entry));
}

std::unique_ptr<Attempt> SimulatedNetwork::connect(const std::string& host, std::uint16_t port,
                                                   Connected connected) {
  auto attempt = std::make_unique<SimulatedAttempt>();
  post([this, live = std::weak_ptr<int>(attempt->live), host, port, connected = std::move(connected)] {
    if (!live.expired()) make_connection(host, port, connected);
  });
  return attempt;
}

void SimulatedNetwork::make_connection(const std::string& host, std::uint16_t port,
                                       const Connected& connected) {
  const std::string peer = host + ":" + std::to_string(port);
  const auto found = ports_.find(port);
  if (found == ports_.end() || !*found->second)
    return connected(Error{peer, "cannot connect: Connection refused"});
  auto end = std::make_shared<SimulatedEnd>();
  end->link = std::make_shared<SimulatedLink>();
  end->link->name = "127.0.0.1:" + std::to_string(++connections_);
  links_.push_back(end->link);
  ends_.push_back(end);
  (*found->second)(std::make_unique<SimulatedConnection>(end->link));
  connected(std::unique_ptr<Connection>(std::make_unique<SimulatedClient>(end, peer)));
}

void SimulatedNetwork::run() {
  while (step()) {
  }
}

void SimulatedNetwork::run_for(double seconds) {
  const double end = now_ + seconds;
  for (run(); !alarms_.empty() && alarms_.begin()->first <= end; run()) {
    auto alarm = alarms_.extract(alarms_.begin());
    now_ = alarm.key();
    if (!alarm.mapped().owner.expired()) alarm.mapped().task();
  }
  now_ = end;
}

bool SimulatedNetwork::step() {
  bool busy = false;
  for (Task& task : std::exchange(tasks_, {})) {
    std::exchange(task, nullptr)();
    busy = true;
  }
  // By index: events may add links.
  for (std::size_t i = 0; i < links_.size(); ++i) busy |= step_link(*std::shared_ptr(links_[i]));
  for (std::size_t i = 0; i < ends_.size(); ++i) busy |= step_end(*std::shared_ptr(ends_[i]));
  std::erase_if(ends_, [](const auto& end) { return end->gone; });
  std::erase_if(links_, [](const auto& link) { return link->closed && link->window.empty(); });
  return busy;
}

bool SimulatedNetwork::step_end(SimulatedEnd& end) {
  if (end.events == nullptr || end.link->stalled) return false;
  const std::vector<std::byte> bytes = std::exchange(end.link->read, {});
  if (!bytes.empty()) {
    end.events->received(bytes);
  } else if (end.link->to_server.empty() && std::exchange(end.draining, false)) {
    end.events->drained();
  } else if (SimulatedPeer(end.link).closed() && !std::exchange(end.told_closed, true)) {
    end.events->closed("closed");
  } else {
    return false;
  }
  return true;
}

bool SimulatedNetwork::step_link(SimulatedLink& link) {
  const auto piece = [this] { return 1 + static_cast<std::size_t>(rng_.bits() % piece_bytes); };
  bool busy = false;

  // Peer to server.
  if (link.events && link.vanished && !std::exchange(link.told_lost, true)) {
    link.events->lost();
    busy = true;
  }
  if (link.events && !link.paused && !link.to_server.empty()) {
    const std::span<const std::byte> front = link.to_server.front(piece());
    const std::vector<std::byte> bytes(front.begin(), front.end());  // the peer may send or vanish meanwhile
    link.to_server.pop(bytes.size());
    link.events->received(bytes);
    busy = true;
  } else if (link.events && !link.paused && (link.finished || link.vanished) &&
             !std::exchange(link.told_closed, true)) {
    link.events->closed(link.vanished ? "lost" : "closed");
    busy = true;
  }

  // Server to peer.
  const std::size_t room = link.window.size() < window_bytes ? window_bytes - link.window.size() : 0;
  busy |= move_front(link.in_flight, std::min(room, piece()), link.window) > 0;
  if (!link.stalled) {
    const std::span<const std::byte> front = link.window.front(piece());
    link.read.insert(link.read.end(), front.begin(), front.end());
    busy |= !front.empty();
    link.window.pop(front.size());
  }
  if (link.in_flight.empty() && std::exchange(link.draining, false)) {
    busy = true;
    if (link.events && !link.vanished) link.events->drained();
  }
  if (link.in_flight.empty() && link.flushing && !std::exchange(link.closed, true)) busy = true;
  return busy;
}

}  // namespace playhouse::net
