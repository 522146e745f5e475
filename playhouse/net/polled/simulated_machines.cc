#include "playhouse/net/polled/simulated_machines.h"

#include <algorithm>
#include <array>
#include <deque>
#include <iterator>
#include <utility>

#include "playhouse/base/assert.h"

namespace playhouse::net {
namespace {

constexpr double kStep = 0.001;  // s that pass at least while everybody waits

/// What one end sends to the other.
struct Direction {
  struct Part {
    std::vector<std::byte> bytes;
    double arrival = 0;  // s
  };
  std::deque<Part> parts;
  std::size_t bytes = 0;
  bool ended = false;  // its sender has closed
};

}  // namespace

struct MachineLink {
  std::array<Direction, 2> sent;  // by the end that connected, by the one that accepted
  bool broken = false;  // one end has crashed: that one carries nothing, the other one hears nothing
};

class SimulatedPolledStream final : public PolledStream {
 public:
  /// `end`: 0 connected, 1 accepted.
  SimulatedPolledStream(SimulatedMachines& machines, std::shared_ptr<MachineLink> link, std::size_t end,
                        std::string peer)
      : network_(machines), link_(std::move(link)), end_(end), peer_(std::move(peer)) {}
  ~SimulatedPolledStream() override { out().ended = true; }

  const std::string& peer() const override { return peer_; }

  Result<std::size_t> send(std::span<const std::span<const std::byte>> parts) override {
    if (has_crashed()) return Error{"", "has crashed"};
    if (in().ended) return Error{"", "Broken pipe"};
    std::size_t all = 0;
    for (const std::span<const std::byte> part : parts) {
      const std::size_t left = out().bytes < network_.room ? network_.room - out().bytes : 0;
      const auto some = part.first(std::min(part.size(), left));
      if (some.empty()) break;
      const double last = out().parts.empty() ? 0 : out().parts.back().arrival;
      out().parts.push_back({{some.begin(), some.end()}, network_.arrival(last)});
      out().bytes += some.size();
      all += some.size();
      if (some.size() < part.size()) break;
    }
    return all;
  }

  Result<std::size_t> receive(std::span<std::byte> to) override {
    if (has_crashed()) return Error{"", "has crashed"};
    std::size_t all = 0;
    while (all < to.size() && has_bytes()) {
      Direction::Part& part = in().parts.front();
      const std::size_t count = std::min(part.bytes.size(), to.size() - all);
      std::ranges::copy(std::span(part.bytes).first(count), to.begin() + static_cast<std::ptrdiff_t>(all));
      part.bytes.erase(part.bytes.begin(), part.bytes.begin() + static_cast<std::ptrdiff_t>(count));
      if (part.bytes.empty()) in().parts.pop_front();
      in().bytes -= count;
      all += count;
    }
    if (all == 0 && hears_end()) return Error{"", "closed the connection"};
    return all;
  }

  bool fulfils(const PollWish& wish) const {
    if (has_crashed()) return true;
    if (wish.reads && (has_bytes() || hears_end())) return true;
    return wish.writes && (out().bytes < network_.room || in().ended);
  }

 private:
  Direction& out() const { return link_->sent[end_]; }
  Direction& in() const { return link_->sent[1 - end_]; }
  /// Only tasks crash, and they connect.
  bool has_crashed() const { return link_->broken && end_ == 0; }
  bool has_bytes() const {
    return !network_.is_cut() && !link_->broken && !in().parts.empty() &&
           in().parts.front().arrival <= network_.now();
  }
  bool hears_end() const { return !network_.is_cut() && !link_->broken && in().ended && in().parts.empty(); }

  SimulatedMachines& network_;
  const std::shared_ptr<MachineLink> link_;
  const std::size_t end_;
  const std::string peer_;
};

class SimulatedPolledListener final : public PolledListener {
 public:
  SimulatedPolledListener(SimulatedMachines& machines, std::uint16_t port,
                          std::shared_ptr<SimulatedMachines::Waiting> waiting)
      : network_(machines), port_(port), waiting_(std::move(waiting)) {}
  ~SimulatedPolledListener() override { network_.ports_.erase(port_); }

  std::uint16_t port() const override { return port_; }
  bool has_somebody() const { return !network_.is_cut() && !waiting_->empty(); }
  std::unique_ptr<PolledStream> accept() override {
    if (!has_somebody()) return nullptr;
    std::shared_ptr<MachineLink> link = std::move(waiting_->front());
    waiting_->erase(waiting_->begin());
    // Each comes from a machine of its own.
    const std::string peer = "10.2.0." + std::to_string(++network_.connections_ % 250) + ":1";
    return std::make_unique<SimulatedPolledStream>(network_, std::move(link), 1, peer);
  }

 private:
  SimulatedMachines& network_;
  const std::uint16_t port_;
  const std::shared_ptr<SimulatedMachines::Waiting> waiting_;
};

SimulatedMachines::~SimulatedMachines() {
  for (std::size_t machine = 0; machine < machines_.size(); ++machine) crash(machine);
  while (!std::ranges::all_of(machines_, &Machine::ended)) pass(kStep);
  for (Machine& machine : machines_) machine.thread.join();
}

std::size_t SimulatedMachines::begin(std::function<void()> work) {
  PLAYHOUSE_ASSERT(running_ == nullptr);
  Machine& machine = machines_.emplace_back();
  machine.is_ready = [] { return true; };
  machine.thread = std::thread([this, &machine, work = std::move(work)] {
    {
      std::unique_lock lock(mutex_);
      machine.goes_on.wait(lock, [&] { return running_ == &machine; });
    }
    work();
    const std::lock_guard lock(mutex_);
    machine.ended = true;
    running_ = nullptr;
    yields_.notify_all();
  });
  return machines_.size() - 1;
}

void SimulatedMachines::crash(std::size_t machine) {
  Machine& crashing = *std::next(machines_.begin(), static_cast<std::ptrdiff_t>(machine));
  crashing.crashed = true;
  for (const auto& link : crashing.links)
    if (const auto open = link.lock()) open->broken = true;
}

bool SimulatedMachines::has_ended(std::size_t machine) const {
  return std::next(machines_.begin(), static_cast<std::ptrdiff_t>(machine))->ended;
}

/// Of the thread that made them: until the machine waits or ends.
void SimulatedMachines::resume(Machine& machine) {
  std::unique_lock lock(mutex_);
  running_ = &machine;
  machine.goes_on.notify_all();
  yields_.wait(lock, [this] { return running_ == nullptr; });
}

/// Of a machine.
void SimulatedMachines::yield(Machine& machine) {
  std::unique_lock lock(mutex_);
  running_ = nullptr;
  yields_.notify_all();
  machine.goes_on.wait(lock, [&] { return running_ == &machine; });
}

/// False: all wait.
bool SimulatedMachines::run_machines() {
  bool any = false;
  for (Machine& machine : machines_) {
    if (machine.ended || !(machine.crashed || now_ >= machine.until || machine.is_ready())) continue;
    resume(machine);
    any = true;
  }
  return any;
}

void SimulatedMachines::pass(double seconds) {
  PLAYHOUSE_ASSERT(running_ == nullptr);
  const double end = now_ + seconds;
  while (now_ < end) {
    while (run_machines()) {
    }
    now_ = std::min(end, now_ + kStep);
  }
}

bool SimulatedMachines::wait(std::span<const PollWish> wishes, PolledListener* listener, double until) {
  const auto is_ready = [wishes = std::vector(wishes.begin(), wishes.end()), listener] {
    if (listener != nullptr && static_cast<SimulatedPolledListener*>(listener)->has_somebody()) return true;
    return std::ranges::any_of(wishes, [](const PollWish& wish) {
      return static_cast<SimulatedPolledStream*>(wish.stream)->fulfils(wish);
    });
  };
  if (running_ != nullptr) {
    Machine& machine = *running_;
    if (is_ready()) return true;
    machine.is_ready = is_ready;
    machine.until = until;
    yield(machine);
    return machine.crashed || is_ready();
  }
  while (!is_ready()) {
    if (now_ >= until) return false;
    if (!run_machines()) now_ = std::min(until, now_ + kStep);
  }
  return true;
}

double SimulatedMachines::arrival(double last) {
  return std::max(last, now_ + delay + jitter * rng_.uniform());
}

Result<std::unique_ptr<PolledStream>> SimulatedMachines::connect(const std::string& host, std::uint16_t port,
                                                                 double) {
  const auto found = ports_.find(port);
  if (found == ports_.end()) return Error{"", "Connection refused"};
  auto link = std::make_shared<MachineLink>();
  if (running_ != nullptr) running_->links.push_back(link);
  found->second->push_back(link);
  return std::unique_ptr<PolledStream>(
      std::make_unique<SimulatedPolledStream>(*this, std::move(link), 0, host + ":" + std::to_string(port)));
}

Result<std::unique_ptr<PolledListener>> SimulatedMachines::listen(const std::string&, std::uint16_t port) {
  if (port == 0) port = next_port_++;
  if (ports_.contains(port)) return Error{"", "Address already in use"};
  const auto waiting = ports_[port] = std::make_shared<Waiting>();
  return std::unique_ptr<PolledListener>(std::make_unique<SimulatedPolledListener>(*this, port, waiting));
}

}  // namespace playhouse::net
