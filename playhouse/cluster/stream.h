#pragma once

/// Stream: messages between head and node of a cluster over a TCP connection.
/// docs/cluster.md specifies the layout. Sockets are non-blocking. Single-threaded.

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "playhouse/base/result.h"

namespace playhouse::cluster {

using Bytes = std::vector<std::byte>;
using Seconds = std::chrono::duration<double>;

enum class Type : std::uint8_t {
  kHello = 1,    // node: the protocol that it speaks
  kWorld = 2,    // head: scene, engine and seed
  kReady = 3,    // node: the engine is made
  kRefusal = 4,  // either: why there is no cooperation; the last message
  kStep = 5,     // head: changes, then a tick
  kShare = 6,    // node: the results of its share
  kResults = 7,  // head: the results of another share
  kEnd = 8,      // head: the run has ended
};

struct Message {
  Type type{};
  std::span<const std::byte> body;
};

/// What the system says of an errno.
std::string reason(int code);

class Stream {
 public:
  /// Takes a connected socket. `limit`: bytes of the largest message that is accepted.
  Stream(int socket, std::size_t limit);
  Stream(Stream&& other) noexcept;
  Stream& operator=(Stream&& other) noexcept;
  ~Stream();

  /// Connects within the time. `host` is a name or a numeric address.
  static Result<Stream> connect(const std::string& host, std::uint16_t port, Seconds patience);

  int socket() const { return socket_; }
  /// Address and port of the peer.
  std::string peer() const;
  void accept_up_to(std::size_t limit) { limit_ = limit; }

  /// Queues a message for flush().
  void queue(Type type, std::span<const std::byte> body);
  /// Sends what is queued as far as the peer takes it, without waiting. True: nothing is left.
  Result<bool> flush();

  /// Sends a message with this body, in pieces, after what is queued; meanwhile receives, up to the limit.
  /// Fails if the peer is gone, or takes nothing for so long.
  Result<void> send(Type type, std::span<const std::span<const std::byte>> body, Seconds patience);
  Result<void> send(Type type, std::initializer_list<std::span<const std::byte>> body, Seconds patience) {
    return send(type, std::span(body), patience);
  }

  /// Receives what has arrived, without waiting. Fails if the peer is gone; what it has sent remains to be
  /// taken.
  Result<void> receive();
  /// The next message, if it has arrived completely; valid until the next call of either. Fails on one over
  /// the limit.
  Result<std::optional<Message>> next();
  /// The next message, waiting for it. No time: for ever.
  Result<Message> wait(std::optional<Seconds> patience);

 private:
  void close();
  bool has_room() const { return in_.size() - begin_ <= limit_; }

  int socket_;
  std::size_t limit_;
  Bytes in_;               // received
  std::size_t begin_ = 0;  // of in_: taken
  Bytes out_;              // queued
  std::size_t sent_ = 0;   // of out_
};

}  // namespace playhouse::cluster
