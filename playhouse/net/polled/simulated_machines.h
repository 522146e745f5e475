#pragma once

/// SimulatedMachines: polled streams in memory, in virtual time, between the thread that made them and machines,
/// which are threads that it begins. One of all runs at a time, and who waits lets the others go on, so that
/// everything repeats for a seed. Bytes come late and in pieces; streams are cut for a while, and machines
/// crash.

#include <condition_variable>
#include <cstdint>
#include <functional>
#include <list>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "playhouse/base/rng.h"
#include "playhouse/net/polled/polled.h"

namespace playhouse::net {

struct MachineLink;

class SimulatedMachines final : public PolledNetwork {
 public:
  explicit SimulatedMachines(std::uint64_t seed) : rng_(seed) {}
  /// Crashes machines that have not ended.
  ~SimulatedMachines() override;
  SimulatedMachines(const SimulatedMachines&) = delete;
  SimulatedMachines& operator=(const SimulatedMachines&) = delete;

  double delay = 0.001, jitter = 0.001;  // s, of bytes
  std::size_t room = 65536;              // bytes on their way or not received

  // Of the thread that made them.

  /// Begins a machine, whose thread goes on while this one waits. `work` may use the streams that it connects,
  /// and now(). Returns its number.
  std::size_t begin(std::function<void()> work);
  /// The streams of a machine carry nothing any more, and each call of it fails.
  void crash(std::size_t machine);
  bool has_ended(std::size_t machine) const;
  /// Lets time pass, and machines go on.
  void pass(double seconds);
  /// Nothing arrives for so many seconds.
  void cut(double seconds) { cut_until_ = now_ + seconds; }

  double now() const override { return now_; }
  bool wait(std::span<const PollWish> wishes, PolledListener* listener, double until) override;
  Result<std::unique_ptr<PolledStream>> connect(const std::string& host, std::uint16_t port,
                                                double seconds) override;
  Result<std::unique_ptr<PolledListener>> listen(const std::string& bind, std::uint16_t port) override;

 private:
  friend class SimulatedPolledStream;
  friend class SimulatedPolledListener;
  struct Machine {
    std::thread thread;
    std::condition_variable goes_on;
    std::function<bool()> is_ready;  // what it waits for
    double until = 0;                // s
    bool ended = false, crashed = false;
    std::vector<std::weak_ptr<MachineLink>> links;
  };
  using Waiting = std::vector<std::shared_ptr<MachineLink>>;  // of one port, not accepted yet

  bool is_cut() const { return now_ < cut_until_; }
  double arrival(double last);
  bool run_machines();
  void resume(Machine& machine);
  void yield(Machine& machine);

  Rng rng_;
  double now_ = 0, cut_until_ = 0;  // s
  std::uint16_t next_port_ = 50000;
  std::uint64_t connections_ = 0;
  std::map<std::uint16_t, std::shared_ptr<Waiting>> ports_;
  std::mutex mutex_;  // of running_; all else is used by whoever runs
  std::condition_variable yields_;
  Machine* running_ = nullptr;  // null: the thread that made them
  std::list<Machine> machines_;
};

}  // namespace playhouse::net
