#pragma once

/// RemoteServer: client side of a connection to another Player server, in
/// PUSH mode, for any number of devices. Bodies are not decoded. Io thread.

#include <compare>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "playhouse/net/network.h"
#include "playhouse/wire/header.h"

namespace playhouse::drivers {

/// A device of that server.
struct RemoteDevice {
  std::uint16_t interf = 0, index = 0;
  friend constexpr auto operator<=>(const RemoteDevice&, const RemoteDevice&) = default;
};

/// "lab:6665", "[::1]:6665"
std::string name_of_server(const std::string& host, std::uint16_t port);

class RemoteServer final : private net::ConnectionEvents {
 public:
  /// `kNotAdmitted`: the server has refused to look at the request, as without a token that it knows.
  enum class RemoteOpening : std::uint8_t { kOpen, kNotOpen, kNotAdmitted };

  class RemoteServerEvents {
   public:
    virtual ~RemoteServerEvents() = default;
    /// The handshake is complete: requests and commands are sent from now on.
    virtual void connected() = 0;
    /// The connection failed or closed: pending requests got NACK, and no device is open.
    virtual void lost(const std::string& why) = 0;
    /// `body` is valid during the call.
    virtual void data(RemoteDevice device, const wire::Header& header, std::span<const std::byte> body) = 0;
    /// Called after data() for everything that arrived together.
    virtual void caught_up() = 0;
    /// The server's answer to open().
    virtual void opened(RemoteDevice device, RemoteOpening opening) = 0;
    /// The device was open and has retired.
    virtual void gone(RemoteDevice device) = 0;
  };
  /// Called once with the reply.
  using ReplyHeard = std::function<void(bool ack, std::span<const std::byte> body)>;

  /// `network` and `events` must outlive it.
  RemoteServer(net::Network& network, std::string host, std::uint16_t port, RemoteServerEvents& events);
  RemoteServer(const RemoteServer&) = delete;
  RemoteServer& operator=(const RemoteServer&) = delete;

  /// As name_of_server().
  const std::string& name() const { return name_; }
  bool is_connected() const { return greeted_; }
  /// True if it is connected in the clear, and nothing was heard from it: so does a server that waits for TLS.
  bool may_speak_tls() const { return connection_ != nullptr && !greeted_ && trust_ == nullptr; }
  /// True if the server is one of this program, of any version. While connected.
  bool is_playhouse() const { return is_playhouse_; }
  const std::string& host() const { return host_; }
  std::uint16_t port() const { return port_; }
  /// Another server from now on. While disconnected.
  void set_server(std::string host, std::uint16_t port);
  /// Authenticates with a guest's token (docs/guests.md), at the present server alone: whoever sets another one
  /// does not get it there. Before connect().
  void set_token(std::string token);
  /// True if the server is one to which the token goes.
  bool has_token() const { return !token_.empty() && name_ == token_for_; }
  /// Speaks TLS, with servers that are trusted; null: in the clear. Before connect().
  void set_trust(std::shared_ptr<net::TlsTrust> trust) { trust_ = std::move(trust); }

  /// Starts connecting unless connecting or connected. The outcome is reported to RemoteServerEvents.
  void connect();
  /// Closes the connection after flushing. No event follows.
  void disconnect();

  // Without a connection these have no effect, and requests get NACK at once.
  void open(RemoteDevice device);
  void close(RemoteDevice device);
  /// Under back-pressure a newer command replaces an older one of its kind, unless a request
  /// to the device came in between: commands and requests of one device keep their order.
  void command(RemoteDevice device, std::uint8_t subtype, std::span<const std::byte> body);
  void ask(RemoteDevice device, std::uint8_t subtype, std::span<const std::byte> body, ReplyHeard heard);

 private:
  using RemoteSubtype = std::pair<RemoteDevice, std::uint8_t>;  // device and subtype of a reply or command
  struct Asked {
    std::uint32_t seq = 0;
    ReplyHeard heard;
  };

  void received(std::span<const std::byte> bytes) override;
  void drained() override;
  void lost() override {}  // closed() follows
  void closed(const std::string& why) override;

  void made(Result<std::unique_ptr<net::Connection>> connection);
  /// False if the peer is not a Player server; true also while the banner is incomplete.
  bool greet();
  void take_messages();
  void take(const wire::Header& header, std::span<const std::byte> body);
  void take_answer(const wire::Header& header, std::span<const std::byte> body);
  bool tells_of_end(const wire::Header& header, std::span<const std::byte> body);
  void authenticate();
  void request_of_server(std::uint8_t subtype, std::span<const std::byte> body, ReplyHeard heard);
  void send(wire::MessageType type, RemoteDevice device, std::uint8_t subtype,
            std::span<const std::byte> body);
  void send_held(RemoteDevice device);
  void fail(const std::string& why);
  std::vector<ReplyHeard> forget();

  net::Network& network_;
  std::string host_;
  std::uint16_t port_;
  std::string name_;
  std::string token_, token_for_;  // empty: none; the name of its server
  std::shared_ptr<net::TlsTrust> trust_;
  RemoteServerEvents& events_;

  std::unique_ptr<net::Attempt> attempt_;
  std::unique_ptr<net::Connection> connection_;
  std::unique_ptr<net::Timer> patience_;  // timeout of the greeting
  bool greeted_ = false, is_playhouse_ = false;
  std::vector<std::byte> input_;  // starts with a header once greeted
  std::uint32_t seq_ = 0;
  std::map<RemoteSubtype, std::deque<Asked>> asked_;
  std::size_t waiting_ = 0;                         // number of entries in asked_
  std::map<RemoteSubtype, net::SharedBytes> held_;  // commands held back under back-pressure
};

}  // namespace playhouse::drivers
