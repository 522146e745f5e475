#pragma once

/// DatagramChannel: packet layer of one end of a session, without its socket: sequence numbers,
/// acknowledgements, loss detection, round-trip time, and the reliable text stream. The rest of
/// a packet belongs to the caller. Format: datagram.h. Times are of any one clock. [s]

#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "playhouse/replicate/datagrams/datagram.h"
#include "playhouse/replicate/datagrams/text_stream.h"

namespace playhouse::replicate {

/// Fate of sent packets, each acknowledged at most once. A
/// packet declared lost may still be acknowledged later.
struct Settled {
  std::vector<Seq> acknowledged, lost;
};

struct ReceivedPacket {
  bool is_new = false;  // false: a duplicate, or too old to tell
  Seq seq = 0;
  bool has_text = false;  // has to be acknowledged
  std::span<const std::byte> state;
};

class DatagramChannel {
 public:
  /// Limit on the length of the other end's texts. `sent`: initial sequence number; for tests.
  DatagramChannel(std::uint64_t session, std::size_t most_text, Seq sent = 0)
      : session_(session), receiver_(most_text), sent_(sent) {}

  void post(std::shared_ptr<const PackedText> text) { sender_.post(std::move(text), sent_); }
  const StreamSender& texts() const { return sender_; }

  /// Writes a packet without its state, which the caller may append, into `out`,
  /// with at most `text_room` bytes of text; returns its seq. It counts as sent.
  Seq write(double now, std::size_t text_room, std::vector<std::byte>& out);

  /// Processes a packet of the session. Fails on a protocol violation.
  Result<ReceivedPacket> receive(std::span<const std::byte> rest, double now);
  Result<std::optional<ReceivedText>> next_text() { return receiver_.next(); }

  /// Packets acknowledged or declared lost since the last call.
  Settled settle(double now);
  /// Packets below this seq are settled.
  Seq oldest() const { return flights_.empty() ? sent_ + 1 : flights_.front().seq; }

  std::uint64_t session() const { return session_; }
  Seq sent() const { return sent_; }                    // last seq
  Seq newest() const { return newest_; }                // highest seq received
  std::uint64_t received() const { return received_; }  // without duplicates
  double round_trip() const { return round_trip_; }     // s, smoothed

 private:
  struct Flight {
    Seq seq = 0;
    double time = 0;
    Piece piece;
    bool is_lost = false;
  };
  bool note(Seq seq);
  void acknowledge(Seq ack, std::uint32_t before, double now);
  double patience() const;

  const std::uint64_t session_;
  StreamSender sender_;
  StreamReceiver receiver_;
  Seq sent_ = 0;
  std::deque<Flight> flights_;  // unacknowledged, oldest first
  std::vector<Seq> acknowledged_;
  Seq newest_ = 0;
  std::uint32_t before_ = 0;  // as in the packet format
  std::uint64_t received_ = 0;
  double round_trip_ = 0.25;
};

}  // namespace playhouse::replicate
