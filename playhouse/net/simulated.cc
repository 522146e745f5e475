#include "playhouse/net/simulated.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <iterator>
#include <limits>
#include <span>

namespace playhouse::net {

constexpr double kArrivals = 0.001;  // s between times at which bytes arrive, so that many do at once

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

/// Bytes on their way: the first ones have arrived, the others will.
class BytesUnderWay {
 public:
  bool empty() const { return bytes_.empty(); }
  std::size_t size() const { return bytes_.size(); }
  /// When the last of them will have arrived [s]; later ones do not overtake them.
  double last_arrival() const { return parts_.empty() ? 0 : parts_.back().arrival; }
  void append(std::span<const std::byte> bytes, double arrival) {
    bytes_.append(bytes);
    sent_ += bytes.size();
    if (!bytes.empty()) parts_.push_back({sent_, arrival});
  }
  /// Of those that have arrived.
  std::span<const std::byte> front(std::size_t most, double now) {
    for (; !parts_.empty() && parts_.front().arrival <= now; parts_.pop_front())
      arrived_ = parts_.front().end;
    return bytes_.front(std::min(most, arrived_ - taken_));
  }
  void pop(std::size_t count) {
    taken_ += count;
    bytes_.pop(count);
  }
  void clear() {
    bytes_.clear();
    parts_.clear();
    taken_ = arrived_ = sent_;
  }

 private:
  struct Part {
    std::size_t end;  // number of bytes up to it, of all that were ever sent
    double arrival;   // s
  };
  ByteQueue bytes_;
  std::deque<Part> parts_;  // those that have not arrived
  std::size_t sent_ = 0, arrived_ = 0, taken_ = 0;
};

/// Both directions of a connection.
struct SimulatedLink {
  SimulatedLink(SimulatedNetwork& its_network, std::string its_name)
      : network(its_network), name(std::move(its_name)) {}

  SimulatedNetwork& network;
  std::string name;
  ConnectionEvents* events = nullptr;
  BytesUnderWay to_server;      // sent by the peer, not delivered
  ByteQueue in_flight;          // sent by the server, not accepted by the "system"
  BytesUnderWay window;         // accepted, not read by the peer
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

}  // namespace

void SimulatedPeer::send(std::span<const std::byte> bytes) {
  if (link_->finished || link_->vanished) return;
  link_->to_server.append(bytes, link_->network.arrival(link_->to_server.last_arrival()));
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
  auto link = std::make_shared<SimulatedLink>(*this, address + ":" + std::to_string(++connections_made_));
  links_.push_back(link);
  after_cut([acceptor = found->second, link] {
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
  after_cut([this, live = std::weak_ptr<int>(attempt->live), host, port, connected = std::move(connected)] {
    if (!live.expired()) make_connection(host, port, connected);
  });
  return attempt;
}

/// In the next run, or after the cut.
void SimulatedNetwork::after_cut(Task task) {
  is_cut() ? run_at(cut_until_, std::move(task)) : post(std::move(task));
}

void SimulatedNetwork::make_connection(const std::string& host, std::uint16_t port,
                                       const Connected& connected) {
  const std::string peer = host + ":" + std::to_string(port);
  const auto found = ports_.find(port);
  if (found == ports_.end() || !*found->second)
    return connected(Error{peer, "cannot connect: Connection refused"});
  auto end = std::make_shared<SimulatedEnd>();
  end->link = std::make_shared<SimulatedLink>(*this, "127.0.0.1:" + std::to_string(++connections_made_));
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
  for (run(); next_event() <= end; run()) {
    now_ = next_event();
    if (wakes_.erase(now_) > 0) continue;  // what has arrived comes before tasks of that time
    auto alarm = alarms_.extract(alarms_.begin());
    if (!alarm.mapped().owner.expired()) alarm.mapped().task();
  }
  now_ = end;
}

double SimulatedNetwork::next_event() const {
  constexpr double kNever = std::numeric_limits<double>::infinity();
  return std::min(alarms_.empty() ? kNever : alarms_.begin()->first,
                  wakes_.empty() ? kNever : *wakes_.begin());
}

bool SimulatedNetwork::step() {
  bool busy = false;
  for (Task& task : std::exchange(tasks_, {})) {
    std::exchange(task, nullptr)();
    busy = true;
  }
  // By index: events may add links; they are removed below alone.
  for (std::size_t i = 0; i < links_.size(); ++i) busy |= step_link(*links_[i]);
  for (std::size_t i = 0; i < ends_.size(); ++i) busy |= step_end(*ends_[i]);
  for (std::size_t i = 0; i < sockets_.size(); ++i) busy |= step_socket(*sockets_[i]);
  std::erase_if(sockets_, [](const auto& socket) { return is_over(*socket); });
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
  bool busy = !is_cut() && carry_input(link);
  busy |= accept_output(link);
  busy |= !is_cut() && carry_output(link);
  if (link.in_flight.empty() && std::exchange(link.draining, false)) {
    busy = true;
    if (link.events && !link.vanished) link.events->drained();
  }
  if (link.in_flight.empty() && link.flushing && !std::exchange(link.closed, true)) busy = true;
  return busy;
}

/// Peer to server.
bool SimulatedNetwork::carry_input(SimulatedLink& link) {
  if (!link.events) return false;
  bool busy = false;
  if (link.vanished && !std::exchange(link.told_lost, true)) {
    link.events->lost();
    busy = true;
  }
  if (!link.events || link.paused) return busy;
  const std::span<const std::byte> front = link.to_server.front(piece(), now_);
  if (!front.empty()) {
    const std::vector<std::byte> bytes(front.begin(), front.end());  // the peer may send or vanish meanwhile
    link.to_server.pop(bytes.size());
    link.events->received(bytes);
    return true;
  }
  if (!link.to_server.empty() || !(link.finished || link.vanished) || std::exchange(link.told_closed, true))
    return busy;
  link.events->closed(link.vanished ? "lost" : "closed");
  return true;
}

/// What the server has sent goes on its way as far as the window has room.
bool SimulatedNetwork::accept_output(SimulatedLink& link) {
  const std::size_t room = link.window.size() < window_bytes ? window_bytes - link.window.size() : 0;
  const std::span<const std::byte> accepted = link.in_flight.front(std::min(room, piece()));
  if (accepted.empty()) return false;
  link.window.append(accepted, arrival(link.window.last_arrival()));
  link.in_flight.pop(accepted.size());
  return true;
}

bool SimulatedNetwork::carry_output(SimulatedLink& link) {
  if (link.stalled) return false;
  const std::span<const std::byte> front = link.window.front(piece(), now_);
  link.read.insert(link.read.end(), front.begin(), front.end());
  link.window.pop(front.size());
  return !front.empty();
}

std::size_t SimulatedNetwork::piece() {
  return 1 + static_cast<std::size_t>(rng_.bits() % piece_bytes);
}

double SimulatedNetwork::arrival(double last) {
  if (connections.delay <= 0 && connections.jitter <= 0) return std::max(last, now_);
  const double time = now_ + connections.delay + connections.jitter * rng_.uniform();
  const double arrival = std::max(last, std::ceil(time / kArrivals) * kArrivals);
  wakes_.insert(arrival);
  return arrival;
}

void SimulatedNetwork::run_at(double time, Task task) {
  const auto always = std::make_shared<int>(0);  // owned by its alarm: never cancelled
  alarms_.emplace(time, Alarm{always, [always, task = std::move(task)] { task(); }});
}

void SimulatedNetwork::cut(double seconds) {
  cut_until_ = std::max(cut_until_, now_ + seconds);
  wakes_.insert(cut_until_);
}

}  // namespace playhouse::net
