#pragma once

/// Server: devices on TCP ports for every client of the Player 3 protocol. Accepts sessions, routes their
/// commands and requests to drivers, and sends what drivers publish to whoever has the device open
/// (docs/server.md). Devices may come and go all the time. Knows drivers only by their interface. Everything
/// is for the io thread or for before the loop runs, but publish() and answer(), which are for any thread.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "playhouse/base/limits.h"
#include "playhouse/base/result.h"
#include "playhouse/device/address.h"
#include "playhouse/device/driver.h"
#include "playhouse/device/turns.h"
#include "playhouse/net/network.h"

namespace playhouse::server {

struct ServerOptions {
  std::string bind = "127.0.0.1";  // numeric address; "0.0.0.0" and "::" mean every interface
  std::string version =
      "3.1.1 Playhouse " PLAYHOUSE_VERSION;       // clients see "Player v." and this, 31 bytes at most
  std::size_t input_bytes = limits::kInputBytes;  // less in tests
  std::size_t output_bytes = limits::kOutputBytes;
};

/// What a person may want to see of a running server. Sums since the start unless said otherwise.
struct ServerStatus {
  std::size_t sessions = 0;          // connected now
  std::size_t stalled_sessions = 0;  // of these, with data waiting that their peers do not read
  std::uint64_t sessions_accepted = 0;
  std::uint64_t sessions_refused = 0;  // over limits::kSessions or limits::kSessionsOfHost
  std::uint64_t sessions_silent = 0;   // closed because they said nothing
  std::uint64_t sessions_broken = 0;   // closed for frames that cannot be, or to make room for others' frames
  std::uint64_t turns = 0;             // of sessions: how often the server looked at one
  std::uint64_t messages_received = 0;
  std::uint64_t messages_sent = 0;
  std::uint64_t bytes_sent = 0;
  std::uint64_t messages_encoded = 0;  // data messages, each once however many sessions got it
  std::size_t output_bytes = 0;        // now: of answers and data that have not gone out
  std::uint64_t data_dropped = 0;      // data that a full queue had no room for
  std::uint64_t commands_dropped = 0;  // commands that no driver could be given
  std::uint64_t requests_refused = 0;  // requests answered NACK by the server itself
  std::size_t devices = 0;             // now
  std::uint64_t devices_retired = 0;
  std::size_t device_rows = 0;  // now: entries about devices in the tables of the server and of its sessions
};

class Server final : public device::Publisher, public device::Outlet {
 public:
  /// `network` outlives the server, and so do the drivers of devices that have not retired; repliers must not
  /// be used after it is gone.
  explicit Server(net::Network& network, ServerOptions options = {});
  /// Closes every session and stops the devices they had open.
  ~Server() override;
  Server(const Server&) = delete;
  Server& operator=(const Server&) = delete;

  /// Opens one more port (0: any free one) and returns its number, which is the `robot` of its devices: each
  /// port is a name space of its own.
  Result<std::uint16_t> listen(std::uint16_t port);

  /// Makes a device known, also while clients are connected. Clients list devices in order of creation.
  Result<device::DeviceId> add_device(device::Address address, device::Driver& driver);

  /// Takes a device out: what was published or answered for it before the call still counts, then it is as if
  /// there had never been one at its address. Requests that its driver has not answered get NACK; clients
  /// that have it open are told (docs/server.md); drivers that hold it get Driver::retired(); if it is open
  /// its driver is told to stop. What comes for it later is dropped, and the driver may go when the call
  /// returns. The address may be given to another device; what clients that are not told yet say to it
  /// is refused. A device that has retired is left alone. Not from inside a call of a driver. From another
  /// thread: network.post([&server, id] { server.retire_device(id); }), which keeps its place behind what
  /// that thread published.
  void retire_device(device::DeviceId device);

  /// Opens a device on behalf of the program, or of a driver that wants to hear when it retires, so that it
  /// runs whoever closes it. release() undoes one hold() of the same holder; once the device has retired it
  /// does nothing. A holder outlives its holds. Fails if the device cannot start, or has retired.
  Result<void> hold(device::DeviceId device, device::Driver* holder = nullptr);
  void release(device::DeviceId device, device::Driver* holder = nullptr);

  /// The time in s that goes into answers; called on the io thread. Default: seconds since 1970.
  void set_clock(std::function<double()> clock);

  /// From now on what clients say that changes something is carried out in these turns; what waits for its
  /// turn stays with its session. Before the loop runs; the turns end no earlier than the loop.
  void take_turns(device::Turns& turns);

  /// The run is over: takes no more clients, sends those it has what waits for them, and calls `done` when
  /// they have it. For a second a client in PULL mode may ask for it, then it goes out unasked; who has not
  /// read it another second later loses it, which is logged.
  void finish(std::function<void()> done);

  /// True while some session gets what the device publishes.
  bool has_readers(device::DeviceId device) const;

  ServerStatus status() const;

  /// Sends each message to every session that has its device open for reading. Any thread; a batch wakes the
  /// io thread once. Timestamps that do not increase are raised by the least step.
  void publish(std::vector<device::Publication> batch) override;
  /// The answer to a request; a session that is gone does not hear it. Any thread.
  void answer(std::uint64_t ticket, bool ack, std::vector<std::byte> body) override;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace playhouse::server
