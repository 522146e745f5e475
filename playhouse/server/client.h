#pragma once

/// Client: a connection of the server with its session: input,
/// turns of work, output, and its end. Io thread only.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "playhouse/net/network.h"
#include "playhouse/server/session.h"

namespace playhouse::server {

class Client;

/// Callbacks of a client.
class ClientOwner {
 public:
  virtual ~ClientOwner() = default;
  /// The client is due (Switchboard::due).
  virtual void schedule() = 0;
  /// Input has arrived; limits the input that all clients hold.
  virtual void make_room() = 0;
  /// Delivers replies that drivers have sent meanwhile.
  virtual void deliver_outbox() = 0;
  /// It has said nothing for limits::kSilentSeconds, or nothing that it had a right to. Destroys the client.
  virtual void remove_silent(Client& client) = 0;
  /// It has broken the protocol or a limit, and is closed.
  virtual void broke(const Client& client) = 0;
  /// Destroys the client.
  virtual void remove(std::uint32_t serial) = 0;
  /// The run is over: a client that has everything is to be closed.
  virtual bool is_over() const = 0;
};

/// "10.0.0.7" of a connection; empty for this machine.
std::string host_of(const net::Connection& connection);

class Client final : public net::ConnectionEvents {
 public:
  /// References must outlive it.
  Client(ClientOwner& owner, net::Network& network, Switchboard& board, std::uint32_t serial,
         std::uint32_t robot, std::unique_ptr<net::Connection> connection)
      : owner_(owner),
        network_(network),
        serial_(serial),
        connection_(std::move(connection)),
        host_(host_of(*connection_)),
        session_(board, serial, robot, connection_->peer()) {}

  /// Sends the banner and starts reading.
  void start(const net::SharedBytes& banner);

  /// Does one turn of work, sends output, and returns the
  /// number of messages executed. May destroy this client.
  std::size_t advance();
  /// True before its first message, and as long as it has no token of those that are needed.
  bool silent() const { return silence_ != nullptr; }
  /// Its network; empty for this machine.
  const std::string& host() const { return host_; }
  /// Bytes that we hold until it reads.
  std::size_t held_bytes() const { return session_.output_bytes() + connection_->in_flight_bytes(); }
  bool stalled() const { return connection_->in_flight_bytes() > 0 && session_.messages_waiting() > 0; }
  /// Logs unread data.
  void tell_unread() const;
  std::uint32_t serial() const { return serial_; }
  Session& session() { return session_; }
  const Session& session() const { return session_; }

 private:
  void received(std::span<const std::byte> bytes) override;
  void drained() override;
  void lost() override;
  void closed(const std::string& why) override;

  void pump();
  void begin_end();
  bool at_end() const;
  bool has_everything() const;
  void remove();

  ClientOwner& owner_;
  net::Network& network_;
  const std::uint32_t serial_;
  std::unique_ptr<net::Connection> connection_;
  const std::string host_;
  Session session_;
  std::vector<net::SharedBytes> parts_;
  bool input_over_ = false, lost_ = false;
  std::unique_ptr<net::Timer> silence_;  // until its first message
  std::unique_ptr<net::Timer> end_;      // timeout of a client that is lost, broken, or has half-closed
};

}  // namespace playhouse::server
