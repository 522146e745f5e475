#pragma once

/// RemoteServer: another Player server as its clients see it. One connection in PUSH mode, over which any
/// number of devices are opened, commanded and asked. Bodies pass as they are. Io thread.

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

/// A device there.
struct RemoteDevice {
  std::uint16_t interf = 0, index = 0;
  friend constexpr auto operator<=>(const RemoteDevice&, const RemoteDevice&) = default;
};

class RemoteServer final : private net::ConnectionEvents {
 public:
  class Events {
   public:
    virtual ~Events() = default;
    /// Requests and commands go out from now on.
    virtual void connected() = 0;
    /// There is no connection, or no more: what was asked has got NACK, and nothing is open there.
    virtual void lost(const std::string& why) = 0;
    /// `body` is valid for the call.
    virtual void data(RemoteDevice device, const wire::Header& header, std::span<const std::byte> body) = 0;
    /// After data() of all that arrived together.
    virtual void caught_up() = 0;
    /// The server does not open the device.
    virtual void refused(RemoteDevice device) = 0;
    /// The device was open, and is no more.
    virtual void gone(RemoteDevice device) = 0;
  };
  /// Called once with the answer.
  using Heard = std::function<void(bool ack, std::span<const std::byte> body)>;

  /// `network` and `events` outlive it.
  RemoteServer(net::Network& network, std::string host, std::uint16_t port, Events& events);
  RemoteServer(const RemoteServer&) = delete;
  RemoteServer& operator=(const RemoteServer&) = delete;

  /// "lab:6665"
  const std::string& name() const { return name_; }
  bool is_connected() const { return greeted_; }

  /// Begins to connect, unless that is under way or done. Events tell how it goes.
  void connect();
  /// Ends the connection once what was sent is out. No event follows.
  void disconnect();

  // Nothing happens without a connection; what is asked then gets NACK at once.
  void open(RemoteDevice device);
  void close(RemoteDevice device);
  /// Where the server takes nothing a newer command replaces an older one of its kind, unless the device was
  /// asked something in between: what one device is told and asked goes out in its order.
  void command(RemoteDevice device, std::uint8_t subtype, std::span<const std::byte> body);
  void ask(RemoteDevice device, std::uint8_t subtype, std::span<const std::byte> body, Heard heard);

 private:
  using Key = std::pair<RemoteDevice, std::uint8_t>;  // of an answer or a command: its device and subtype
  struct Asked {
    std::uint32_t seq = 0;
    Heard heard;
  };

  void received(std::span<const std::byte> bytes) override;
  void drained() override;
  void lost() override {}  // closed() follows
  void closed(const std::string& why) override;

  void made(Result<std::unique_ptr<net::Connection>> connection);
  /// False where those are no bytes of a Player server; true also while there are too few of them.
  bool greet();
  void take_messages();
  void take(const wire::Header& header, std::span<const std::byte> body);
  void take_answer(const wire::Header& header, std::span<const std::byte> body);
  bool tells_of_end(const wire::Header& header, std::span<const std::byte> body);
  void request_of_server(std::uint8_t subtype, std::span<const std::byte> body, Heard heard);
  void send(wire::MessageType type, RemoteDevice device, std::uint8_t subtype,
            std::span<const std::byte> body);
  void send_held(RemoteDevice device);
  void fail(const std::string& why);
  std::vector<Heard> forget();

  net::Network& network_;
  const std::string host_;
  const std::uint16_t port_;
  const std::string name_;
  Events& events_;

  std::unique_ptr<net::Attempt> attempt_;
  std::unique_ptr<net::Connection> connection_;
  std::unique_ptr<net::Timer> patience_;  // for the greeting
  bool greeted_ = false;
  std::vector<std::byte> input_;  // begins at a header once greeted
  std::uint32_t seq_ = 0;
  std::map<Key, std::deque<Asked>> asked_;
  std::size_t waiting_ = 0;               // in asked_
  std::map<Key, net::SharedBytes> held_;  // commands that wait until the server takes what is under way
};

}  // namespace playhouse::drivers
