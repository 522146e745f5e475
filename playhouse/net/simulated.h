#pragma once

/// An in-memory network for tests: connections deliver bytes in random pieces, in virtual time, delayed as
/// configured; peers can stall or vanish; datagrams are lost, duplicated, delayed and reordered as configured;
/// and all of it can be cut for a while.
/// Deterministic for a seed and a sequence of calls. One thread; no sockets, no blocking.

#include <cstdint>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "playhouse/base/rng.h"
#include "playhouse/net/network.h"
#include "playhouse/net/serial/simulated_serial.h"
#include "playhouse/net/simulated_page.h"

namespace playhouse::net {

struct SimulatedLink;
struct SimulatedEnd;
struct HttpRequest;

/// The test's end of a connection. A handle: copies refer to the same peer.
class SimulatedPeer {
 public:
  explicit SimulatedPeer(std::shared_ptr<SimulatedLink> link) : link_(std::move(link)) {}

  void send(std::span<const std::byte> bytes);
  /// Half-closes: no more bytes will be sent; the peer still reads.
  void finish();
  /// Vanishes silently: bytes in transit in either direction are lost.
  void vanish();
  /// Resets: bytes it has sent arrive, bytes sent to it are lost.
  void reset();
  /// Stops reading: the sender's bytes fill the window, then stay in flight.
  void stall();
  void read_on();
  /// Everything received so far; clears it.
  std::vector<std::byte> take();
  /// The other side has closed.
  bool closed() const;

 private:
  std::shared_ptr<SimulatedLink> link_;
};

/// Faults of datagrams.
struct DatagramFaults {
  double loss = 0, duplication = 0;  // chance of each
  double delay = 0.01;               // s, constant part
  double jitter = 0;                 // s, random part: causes reordering
};

/// How long what a connection carries is on its way; its order stays.
struct ConnectionDelay {
  double delay = 0;   // s, constant part
  double jitter = 0;  // s, random part
};

class SimulatedNetwork final : public Network {
 public:
  explicit SimulatedNetwork(std::uint64_t seed) : rng_(seed) {}
  ~SimulatedNetwork() override;

  /// Receive window: bytes buffered for a peer that does not read.
  std::size_t window_bytes = 65536;
  /// Maximum size of pieces.
  std::size_t piece_bytes = 4096;
  DatagramFaults datagrams;
  ConnectionDelay connections;  // of what is sent from now on
  /// Serial lines: their faults, and plugs that are pulled.
  SimulatedSerial& serial() { return serial_; }

  /// Connects to an open port (asserted). The acceptor runs in the next run().
  SimulatedPeer connect(std::uint16_t port, const std::string& address = "127.0.0.1");
  /// Has a page open a WebSocket at a port that serves HTTP (asserted), with this request.
  SimulatedPage open_page(std::uint16_t port, HttpRequest request);
  /// Nothing arrives for `seconds` from now on: connections deliver what they carry afterwards, datagrams
  /// are lost.
  void cut(double seconds);
  bool is_cut() const { return now_ < cut_until_; }
  /// Processes everything due now.
  void run();
  /// The same for `seconds` of virtual time, timers included.
  void run_for(double seconds);

  void post(Task task) override;
  [[nodiscard]] std::unique_ptr<Timer> after(double seconds, Task task) override;
  Result<std::unique_ptr<Listener>> listen(const std::string& bind, std::uint16_t port,
                                           Acceptor acceptor) override;
  /// Pages (simulated_page.h) come by messages: neither HTTP nor frames of WebSockets are simulated.
  Result<std::unique_ptr<Listener>> listen_http(const std::string& bind, std::uint16_t port,
                                                HttpService& service) override;
  /// `bind` is an arbitrary simulated address, at which the socket receives; that of a group joins it.
  Result<std::unique_ptr<DatagramSocket>> open_datagrams(const std::string& bind, std::uint16_t port,
                                                         DatagramSocket::Receiver receiver) override;
  double now() const override { return now_; }
  /// Any host name refers to this network's own ports.
  [[nodiscard]] std::unique_ptr<Attempt> connect(const std::string& host, std::uint16_t port,
                                                 Connected connected) override;
  Result<std::unique_ptr<SerialLine>> open_serial(const std::string& path,
                                                  const SerialSettings& settings) override {
    return serial_.open_port(path, settings);
  }
  Result<std::unique_ptr<SerialLine>> open_terminal(const std::string& link,
                                                    const SerialSettings& settings) override {
    return serial_.open_terminal(link, settings);
  }

 private:
  struct Alarm {
    std::weak_ptr<int> owner;
    Task task;
  };
  friend class SimulatedDatagrams;
  friend class SimulatedPeer;
  friend class SimulatedPage;
  /// When what is sent now will have arrived, after `last`, when what was sent before it will have.
  double arrival(double last);
  void run_at(double time, Task task);
  /// When there is something to do. [s; may be infinite]
  double next_event() const;
  bool step();
  void carry(const Endpoint& from, const Endpoint& to, std::span<const std::byte> bytes);
  bool step_link(SimulatedLink& link);
  bool carry_input(SimulatedLink& link);
  bool accept_output(SimulatedLink& link);
  bool carry_output(SimulatedLink& link);
  std::size_t piece();
  void after_cut(Task task);
  bool step_end(SimulatedEnd& end);
  bool step_socket(SimulatedSocket& socket);
  bool carry_commands(SimulatedSocket& socket);
  bool accept_messages(SimulatedSocket& socket);
  static bool is_over(const SimulatedSocket& socket);
  void make_connection(const std::string& host, std::uint16_t port, const Connected& connected);

  Rng rng_;
  SimulatedSerial serial_{*this, rng_};
  double now_ = 0;
  double cut_until_ = 0;  // s
  std::uint16_t next_port_ = 40000;
  std::uint64_t connections_made_ = 0;
  std::vector<Task> tasks_;
  std::multimap<double, Alarm> alarms_;
  std::set<double> wakes_;  // s; all connections are looked at then
  std::map<Endpoint, std::vector<std::weak_ptr<DatagramSocket::Receiver>>>
      datagram_ports_;  // of a group: many
  std::map<std::uint16_t, std::shared_ptr<Acceptor>> ports_;
  std::vector<std::shared_ptr<SimulatedLink>> links_;
  std::vector<std::shared_ptr<SimulatedEnd>> ends_;  // clients' ends
  std::map<std::uint16_t, std::shared_ptr<HttpService*>> services_;
  std::vector<std::shared_ptr<SimulatedSocket>> sockets_;
};

}  // namespace playhouse::net
