#pragma once

/// DatagramChannel: one end of a session's packets, without its socket: which packets came and which arrived,
/// how long they take, and the stream of texts among them. What else a packet holds is the caller's. Drawn in
/// datagram.h. Times are of any one clock. [s]

#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "playhouse/replicate/datagram.h"
#include "playhouse/replicate/text_stream.h"

namespace playhouse::replicate {

/// What became of packets that were sent, each acknowledged once at most. One that was thought lost may be
/// acknowledged later all the same.
struct Settled {
  std::vector<Seq> acknowledged, lost;
};

struct Heard {
  bool is_new = false;  // else it came before, or is too old to be told apart
  Seq seq = 0;
  bool has_text = false;  // and so wants an acknowledgement
  std::span<const std::byte> state;
};

class DatagramChannel {
 public:
  /// Texts from the other end are at most so long. `sent`: as if so many packets had gone already; in tests.
  DatagramChannel(std::uint64_t session, std::size_t most_text, Seq sent = 0)
      : session_(session), receiver_(most_text), sent_(sent) {}

  void post(std::shared_ptr<const PackedText> text) { sender_.post(std::move(text), sent_); }
  const StreamSender& texts() const { return sender_; }

  /// Writes a packet up to its state, which the caller may append, with at most `text_room` bytes of a piece
  /// of text, into `out`; returns its seq. It counts as sent.
  Seq write(double now, std::size_t text_room, std::vector<std::byte>& out);
  /// Of the last write().
  bool carries_text() const { return !flights_.empty() && flights_.back().piece.size > 0; }

  /// Takes a packet of the session. Fails for what the other end never sends.
  Result<Heard> receive(std::span<const std::byte> rest, double now);
  Result<std::optional<ReceivedText>> next_text() { return receiver_.next(); }

  /// What has been decided since the last call.
  Settled settle(double now);
  /// Packets before are decided for good.
  Seq oldest() const { return flights_.empty() ? sent_ + 1 : flights_.front().seq; }

  std::uint64_t session() const { return session_; }
  Seq sent() const { return sent_; }                    // seq of the last
  Seq newest() const { return newest_; }                // seq of the other end's last
  std::uint64_t received() const { return received_; }  // new ones
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
  std::deque<Flight> flights_;  // not acknowledged, the oldest first
  std::vector<Seq> acknowledged_;
  Seq newest_ = 0;
  std::uint32_t before_ = 0;  // as drawn
  std::uint64_t received_ = 0;
  double round_trip_ = 0.25;
};

}  // namespace playhouse::replicate
