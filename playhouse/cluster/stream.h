#pragma once

/// MessageStream: messages between head and node of a cluster over a polled stream.
/// docs/cluster.md specifies the layout. Single-threaded.

#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <initializer_list>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "playhouse/base/packing.h"
#include "playhouse/base/result.h"
#include "playhouse/net/polled/polled.h"

namespace playhouse::cluster {

using Seconds = std::chrono::duration<double>;

enum class NodeMessageType : std::uint8_t {
  kHello = 1,    // node: the protocol that it speaks
  kWorld = 2,    // head: scene, engine and seed
  kReady = 3,    // node: the engine is made
  kRefusal = 4,  // either: why there is no cooperation; the last message
  kStep = 5,     // head: changes, then a tick
  kShare = 6,    // node: the results of its share
  kResults = 7,  // head: the results of another share
  kEnd = 8,      // head: the run has ended
};

struct NodeMessage {
  NodeMessageType type{};
  std::span<const std::byte> body;
};

/// When waiting ends, whatever has arrived until then: a peer cannot put it off byte by byte.
struct Until {
  double deadline = 0;                         // s, of the clock of the network
  const std::atomic<bool>* stopped = nullptr;  // ends it as well, within 50 ms
};
/// `patience` from `now` [s] on, and the time of `bytes` on a slow network.
Until until(double now, Seconds patience, std::size_t bytes = 0, const std::atomic<bool>* stopped = nullptr);

class MessageStream {
 public:
  /// `limit`: bytes of the largest message that is accepted. The network must outlive it.
  MessageStream(net::PolledNetwork& network, std::unique_ptr<net::PolledStream> bytes, std::size_t limit)
      : network_(&network), bytes_(std::move(bytes)), limit_(limit) {}

  /// Connects within the time. `host` is a name or a numeric address.
  static Result<MessageStream> connect(net::PolledNetwork& network, const std::string& host,
                                       std::uint16_t port, Seconds patience);

  /// Address and port of the peer.
  const std::string& peer() const { return bytes_->peer(); }
  /// Of who waits for its messages, and for room for those that are queued.
  net::PollWish wish() const { return {bytes_.get(), true, has_queued()}; }
  void accept_up_to(std::size_t limit) { limit_ = limit; }

  /// Queues a message for flush(). The body is shared, not copied.
  void queue(NodeMessageType type, std::shared_ptr<const Bytes> body);
  bool has_queued() const { return !queued_.empty(); }
  /// Sends what is queued as far as the peer takes it, without waiting, `most` bytes at most. Returns their
  /// number.
  Result<std::size_t> flush(std::size_t most);

  /// Sends a message with this body, in pieces, after what is queued; meanwhile receives, up to the limit.
  /// Fails if the peer is gone, or has not taken it all in time.
  Result<void> send(NodeMessageType type, std::span<const std::span<const std::byte>> body, Until until);
  Result<void> send(NodeMessageType type, std::initializer_list<std::span<const std::byte>> body,
                    Until until) {
    return send(type, std::span(body), until);
  }
  /// The patience grows with the size of the message.
  Result<void> send(NodeMessageType type, std::initializer_list<std::span<const std::byte>> body,
                    Seconds patience);

  /// Receives what has arrived, without waiting. Fails if the peer is gone; what it has sent remains to be
  /// taken.
  Result<void> receive();
  /// The next message, if it has arrived completely; valid until the next call of either. Fails on one over
  /// the limit.
  Result<std::optional<NodeMessage>> next();
  /// The next message, waiting for it. The patience is for its first byte, none: for ever; the rest has to
  /// follow at the rate of a slow network.
  Result<NodeMessage> wait(std::optional<Seconds> patience);

 private:
  bool wait_for(bool reads, bool writes, const Until& until);
  Result<void> send_all(std::span<std::span<const std::byte>> parts, std::size_t size, const Until& until);
  std::size_t announced() const;
  bool has_room() const { return in_.size() - begin_ <= limit_; }

  net::PolledNetwork* network_;
  std::unique_ptr<net::PolledStream> bytes_;
  std::size_t limit_;
  Bytes in_;               // received
  std::size_t begin_ = 0;  // of in_: taken
  std::deque<std::shared_ptr<const Bytes>> queued_;
  std::size_t sent_ = 0;  // of the first of queued_
};

}  // namespace playhouse::cluster
