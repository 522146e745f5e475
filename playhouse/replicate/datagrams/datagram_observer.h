#pragma once

/// DatagramObserver: the observer's end of a session, without its socket: joins, keeps a
/// replica of the world, and acknowledges packets. One thread. Times are of any one clock. [s]

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "playhouse/replicate/datagrams/datagram_channel.h"
#include "playhouse/replicate/datagrams/observed_world.h"

namespace playhouse::replicate {

class DatagramObserver {
 public:
  /// `nonce` must be unpredictable: an answer with it comes from somebody who received our hello.
  DatagramObserver(std::uint64_t nonce, Terms wanted, std::string token, double now)
      : nonce_(nonce), wanted_(wanted), token_(std::move(token)), heard_(now) {}

  void receive(std::span<const std::byte> datagram, double now);
  /// The next datagram to send; none: call again in a few ms. Call in a loop until none.
  std::optional<std::vector<std::byte>> next(double now);
  /// Sends a command (docs/viewer-protocol.md).
  void command(std::string_view text);
  /// The datagram that ends the session; none before the welcome.
  std::optional<std::vector<std::byte>> bye() const;

  /// Reason for the end: refused, kicked, or timed out. None: the session is open.
  const std::optional<std::string>& ended() const { return ended_; }
  bool has_joined() const { return channel_.has_value(); }
  const ObservedWorld& world() const { return world_; }
  ObservedWorld& world() { return world_; }
  Terms terms() const { return terms_; }  // as granted

  std::uint64_t packets() const { return channel_ ? channel_->received() : 0; }
  /// Sent by the other end and not received, though they may still arrive.
  std::uint64_t packets_missing() const { return channel_ ? channel_->newest() - channel_->received() : 0; }
  std::uint64_t bytes() const { return bytes_; }  // received, in datagrams
  std::uint64_t datagrams() const { return datagrams_; }
  double round_trip() const { return channel_ ? channel_->round_trip() : 0; }

 private:
  void take_challenge(const Challenge& challenge);
  void take_welcome(const Welcome& welcome);
  void take_packet(const PacketOf& packet, double now);

  const std::uint64_t nonce_;
  const Terms wanted_;
  const std::string token_;
  Terms terms_;
  std::optional<std::uint64_t> cookie_;
  std::optional<DatagramChannel> channel_;
  ObservedWorld world_;
  std::vector<std::shared_ptr<const PackedText>> commands_;  // issued before the welcome
  std::optional<std::string> ended_;
  double heard_, asked_ = -1e9, sent_ = -1e9;
  double asked_for_ = 0.25;           // s until the next retry
  std::uint32_t unacknowledged_ = 0;  // packets received since we last sent one
  std::uint64_t bytes_ = 0, datagrams_ = 0;
};

}  // namespace playhouse::replicate
