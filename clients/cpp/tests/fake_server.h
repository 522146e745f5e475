#pragma once

/// A scripted server for one client, in a thread of its own.

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "playhouse/wire/codec.h"
#include "playhouse/wire/header.h"

namespace playhouse::client {

/// A received message.
struct Received {
  wire::Header header;
  std::vector<std::byte> body;
};

/// The server's end of the connection, for scripts.
class Peer {
 public:
  explicit Peer(int fd) : fd_(fd) {}

  /// The client's next message; none at end of stream.
  std::optional<Received> receive();
  void send(std::span<const std::byte> bytes);
  void send(std::string_view text) { send(std::as_bytes(std::span(text))); }

  void say(wire::Header header, std::span<const std::byte> body);
  void answer(const Received& request, std::span<const std::byte> body = {},
              wire::MessageType type = wire::MessageType::kAck);
  /// DATA of position2d:0 with `x` as its pose.
  void position(double x, double timestamp = 1.0);
  void synch();
  void overflow(std::uint32_t lost);

  /// Acknowledges requests of mode and access, and passes the rest to `rest`, until the client disconnects.
  void serve(const std::function<void(const Received&)>& rest);

  /// From now on passes one byte per call of send(2).
  void dribble() { piece_ = 1; }

  std::vector<Received> received;  // everything so far

 private:
  bool read_exactly(std::span<std::byte> out);

  int fd_;
  std::size_t piece_ = SIZE_MAX;
};

class FakeServer {
 public:
  using Script = std::function<void(Peer&)>;

  explicit FakeServer(Script script, std::string banner = "Player v.3.1.1");
  /// Waits for the script to end.
  ~FakeServer();

  std::string address() const { return "127.0.0.1:" + std::to_string(port_); }
  /// What the client sent, in order. Only after finish().
  const std::vector<Received>& received() const { return received_; }
  /// Waits for the script to end.
  void finish();

 private:
  void run(const Script& script, std::string banner);

  int listener_;
  std::uint16_t port_ = 0;
  std::vector<Received> received_;
  std::thread thread_;
};

}  // namespace playhouse::client
