#pragma once

/// Server: devices on TCP ports for clients of the Player 3 protocol. Accepts sessions,
/// dispatches their commands and requests to drivers, and forwards published data to sessions
/// with the device open (docs/server.md). Devices may be added and retired at any time.
/// Threads: io thread, or before the loop runs, except publish() and answer(): any thread.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "playhouse/base/limits.h"
#include "playhouse/base/result.h"
#include "playhouse/base/version.h"
#include "playhouse/device/address.h"
#include "playhouse/device/caller.h"
#include "playhouse/device/driver.h"
#include "playhouse/device/turns.h"
#include "playhouse/net/network.h"
#include "playhouse/server/datagram_port.h"
#include "playhouse/server/multicast_group.h"

namespace playhouse::server {

struct ServerOptions {
  std::string bind = "127.0.0.1";  // numeric address; "0.0.0.0" and "::" mean every interface
  // Clients see "Player v." and this, 31 bytes at most: no room for the commit.
  std::string version = "3.1.1 Playhouse " + std::string(playhouse::version());
  std::size_t input_bytes = limits::kInputBytes;  // smaller in tests
  std::size_t output_bytes = limits::kOutputBytes;
  std::size_t outbox_bytes = limits::kOutboxBytes;
  std::size_t sessions = limits::kSessions;  // fewer where descriptors are few
  std::string unix_folder = {};              // each port has a Unix socket there as well; empty: none
  bool datagrams = false;                    // each port is one of UDP as well
  /// Data also go there, once for all clients that ask for it; in the clear, so not with TLS, and listen() fails
  /// with admit_by().
  std::optional<net::Endpoint> group = {};

  /// Divides so many MiB among the three of memory, as limits::kClientMiB is divided.
  void share_memory(std::size_t mib) {
    const auto part = [mib](std::size_t bytes) { return bytes / limits::kClientMiB * mib; };
    input_bytes = part(limits::kInputBytes);
    output_bytes = part(limits::kOutputBytes);
    outbox_bytes = part(limits::kOutboxBytes);
  }
};

/// Metrics of a running server. Totals since the start unless stated otherwise.
struct ServerStatus {
  std::size_t sessions = 0;          // connected now
  std::size_t stalled_sessions = 0;  // of these, with queued data that their peers do not read
  std::uint64_t sessions_accepted = 0;
  std::uint64_t sessions_refused = 0;  // over limits::kSessions or limits::kSessionsOfHost
  std::uint64_t sessions_silent = 0;   // closed: no message within the timeout
  std::uint64_t sessions_broken = 0;   // closed for invalid frames, or to free input memory
  std::uint64_t turns = 0;             // session turns: how often the server worked on one
  std::uint64_t messages_received = 0;
  std::uint64_t messages_sent = 0;
  std::uint64_t bytes_sent = 0;
  std::uint64_t messages_encoded = 0;  // data messages, each once for all sessions
  std::size_t output_bytes = 0;        // now: bytes of unsent replies and data
  std::uint64_t data_dropped = 0;      // data dropped by full queues
  std::uint64_t commands_dropped = 0;  // commands not accepted by a driver
  std::uint64_t requests_refused = 0;  // requests answered NACK by the server itself
  std::size_t devices = 0;             // now
  std::uint64_t devices_retired = 0;
  std::size_t device_rows = 0;  // now: entries for devices in tables of the server and its sessions
  DatagramCounts datagrams;     // of all ports
  GroupCounts group;
};

/// A connected client.
struct ClientStatus {
  std::string peer;                   // "address:port"
  std::uint32_t port = 0;             // of the server
  std::vector<device::Address> open;  // devices
};

class Server final : public device::Publisher, public device::Outlet {
 public:
  /// `network` must outlive the server, as must the drivers of devices
  /// that have not retired; repliers must not be used afterwards.
  explicit Server(net::Network& network, ServerOptions options = {});
  /// Closes every session and stops the devices they had open.
  ~Server() override;
  Server(const Server&) = delete;
  Server& operator=(const Server&) = delete;

  /// Starts listening on one more port (0: any free one) and returns it, in all ways of the options;
  /// it is the `robot` of its devices: each port is a name space.
  Result<std::uint16_t> listen(std::uint16_t port);

  /// Serves a client that has connected in another way, as one of this open port.
  void accept(std::uint16_t port, std::unique_ptr<net::Connection> connection);
  bool has_port(std::uint16_t port) const;

  /// Registers a device, also while clients are connected. Clients list devices in order of registration.
  Result<device::DeviceId> add_device(device::Address address, device::Driver& driver);

  /// Retires a device: what was published or answered before still counts, afterwards
  /// its address is empty. Pending requests get NACK; clients that have it open are
  /// notified (docs/server.md); holders get Driver::retired(); if open, its driver is
  /// told to stop. Later data for it is dropped, and the driver may be destroyed after
  /// the call. The address may be reused; messages from clients that were not notified
  /// yet are rejected. No effect on a retired device. Not from inside a driver call.
  /// From another thread: network.post([&server, id] { server.retire_device(id); }),
  /// which stays in order with what that thread published.
  void retire_device(device::DeviceId device);
  /// Stops all devices, at the end of the program: their drivers may still answer. Not while the network runs.
  void stop_devices();

  /// Opens a device on behalf of the program, or of a driver that wants to be notified of its
  /// retirement. release() undoes one hold() of the same holder, without effect once the device has
  /// retired. A holder must outlive its holds. Fails if the device cannot start, or has retired.
  Result<void> hold(device::DeviceId device, device::Driver* holder = nullptr);
  /// Gets what the device needs of other servers before a hold(): Driver::prepare().
  void prepare(device::DeviceId device, device::Driver::Prepared heard);
  void release(device::DeviceId device, device::Driver* holder = nullptr);

  /// Clock for timestamps of replies [s]; called on the io thread. Default: Unix time.
  void set_clock(std::function<double()> clock);

  /// Executes clients' modifying messages in these turns from now on; messages out of turn
  /// wait in their session. Before the loop runs; `turns` must outlive the loop's run.
  void take_turns(device::Turns& turns);

  /// Access control: every client begins with the rights of the token "*", or with none, and gets others by
  /// AUTH (docs/guests.md). Before the loop runs, or on the io thread, for clients that come later; called
  /// there.
  using Admit =
      std::function<std::optional<device::Rights>(const std::string& token, const std::string& peer)>;
  void admit_by(Admit admit);
  /// Closes the connections of the clients that have this token ("*": none) and peer. Any thread.
  void close_clients(std::function<bool(const std::string& token, const std::string& peer)> which);

  /// Graceful shutdown: accepts no more clients, flushes all queues, then calls
  /// `done`. Clients in PULL mode have a second to ask for data before it is
  /// sent unasked; what is unread after another second is lost, and logged.
  void finish(std::function<void()> done);

  /// True if a session is subscribed to the device.
  bool has_readers(device::DeviceId device) const;

  ServerStatus status() const;
  /// The devices of all ports, by their addresses.
  std::map<device::Address, device::DeviceId> devices() const;
  /// Those connected now, in the order of their connections.
  std::vector<ClientStatus> clients() const;

  /// Sends each message to those sessions with its device open for reading that it is for. Any thread; one
  /// wake-up per batch. Timestamps that do not increase are raised by the least step.
  void publish(std::vector<device::Publication> batch) override;
  /// Removes data that clients have not been sent, before what follows. Any thread.
  void forget() override;
  /// Replies to a request; dropped if the session is gone. Any thread.
  void answer(std::uint64_t ticket, bool ack, std::vector<std::byte> body) override;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace playhouse::server
