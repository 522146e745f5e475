#pragma once

/// A network in memory for tests: connections deliver bytes in random pieces, in virtual time, with peers
/// that stall or vanish; datagrams are lost, doubled, late and overtaken as it is told. The same seed and the same calls give the same run. One thread; no sockets, no
/// waiting.

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "playhouse/base/rng.h"
#include "playhouse/net/network.h"

namespace playhouse::net {

struct SimulatedLink;
struct SimulatedEnd;

/// The test's end of a connection. A handle: copies speak for the same peer.
class SimulatedPeer {
 public:
  explicit SimulatedPeer(std::shared_ptr<SimulatedLink> link) : link_(std::move(link)) {}

  void send(std::span<const std::byte> bytes);
  /// Says that no more bytes will come; the peer still reads.
  void finish();
  /// Vanishes without a word: what is under way in either direction is lost.
  void vanish();
  /// Vanishes as by a reset: what it has sent arrives, what is sent to it is lost.
  void reset();
  /// Stops reading: the other side's bytes fill the window and then stay in flight.
  void stall();
  void read_on();
  /// Everything the other side sent and this peer has read; clears it.
  std::vector<std::byte> take();
  /// The other side has closed.
  bool closed() const;

 private:
  std::shared_ptr<SimulatedLink> link_;
};

/// What happens to each datagram on its way.
struct DatagramFaults {
  double loss = 0, duplication = 0;  // chance of each
  double delay = 0.01;               // s, of all
  double jitter = 0;                 // s, at random besides: who waits for less overtakes
};

class SimulatedNetwork final : public Network {
 public:
  explicit SimulatedNetwork(std::uint64_t seed) : rng_(seed) {}
  ~SimulatedNetwork() override;

  /// How many bytes the "system" buffers for a peer that does not read.
  std::size_t window_bytes = 65536;
  /// Pieces have 1 to this many bytes.
  std::size_t piece_bytes = 4096;
  DatagramFaults datagrams;

  /// A connection to an open port; asserts that somebody listens there. The acceptor runs in the next run().
  SimulatedPeer connect(std::uint16_t port, const std::string& address = "127.0.0.1");
  /// Does everything there is to do now.
  void run();
  /// The same up to `seconds` of virtual time from now, timers included.
  void run_for(double seconds);

  void post(Task task) override;
  [[nodiscard]] std::unique_ptr<Timer> after(double seconds, Task task) override;
  Result<std::unique_ptr<Listener>> listen(const std::string& bind, std::uint16_t port,
                                           Acceptor acceptor) override;
  /// `bind` is the address of the simulated host, whatever it is: what is sent to it arrives there.
  Result<std::unique_ptr<DatagramSocket>> open_datagrams(const std::string& bind, std::uint16_t port,
                                                         DatagramSocket::Receiver receiver) override;
  double now() const override { return now_; }
  /// Whatever the host is called: it is this network's own port, or nobody is there.
  [[nodiscard]] std::unique_ptr<Attempt> connect(const std::string& host, std::uint16_t port,
                                                 Connected connected) override;

 private:
  struct Alarm {
    std::weak_ptr<int> owner;
    Task task;
  };
  friend class SimulatedDatagrams;
  bool step();
  void carry(const Endpoint& from, const Endpoint& to, std::span<const std::byte> bytes);
  bool step_link(SimulatedLink& link);
  bool step_end(SimulatedEnd& end);
  void make_connection(const std::string& host, std::uint16_t port, const Connected& connected);

  Rng rng_;
  double now_ = 0;
  std::uint16_t next_port_ = 40000;
  std::uint64_t connections_ = 0;
  std::vector<Task> tasks_;
  std::multimap<double, Alarm> alarms_;
  std::map<Endpoint, std::weak_ptr<DatagramSocket::Receiver>> datagram_ports_;
  std::map<std::uint16_t, std::shared_ptr<Acceptor>> ports_;
  std::vector<std::shared_ptr<SimulatedLink>> links_;
  std::vector<std::shared_ptr<SimulatedEnd>> ends_;  // of those who connected
};

}  // namespace playhouse::net
