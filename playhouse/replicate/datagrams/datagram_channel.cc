#include "playhouse/replicate/datagrams/datagram_channel.h"

#include <algorithm>
#include <utility>

namespace playhouse::replicate {
namespace {

/// s; an unacknowledged packet is forgotten after that, even if its ack arrives later.
constexpr double kForgotten = 3;
constexpr double kLeastPatience = 0.1, kMostPatience = 2.5;
/// Allowance for delayed acknowledgements: 25 ms by an observer, a frame by the server. [s]
constexpr double kAckDelay = 0.05;
constexpr double kSmoothing = 0.125;

}  // namespace

double DatagramChannel::patience() const {
  return std::clamp(2 * round_trip_ + kAckDelay, kLeastPatience, kMostPatience);
}

Seq DatagramChannel::write(double now, std::size_t text_room, std::vector<std::byte>& out) {
  out.clear();
  Packer pack(out);
  begin_packet(session_, pack);
  pack.varint(++sent_);
  pack.varint(newest_);
  pack.u32(before_);
  pack.varint(receiver_.taken());
  const Piece piece = sender_.next(text_room);
  pack.varint(piece.size);
  if (piece.size > 0) {
    pack.varint(piece.at);
    sender_.write(piece, pack);
  }
  flights_.push_back({sent_, now, piece, false});
  return sent_;
}

Result<ReceivedPacket> DatagramChannel::receive(std::span<const std::byte> rest, double now) {
  Unpacker in(rest);
  const std::uint64_t seq = in.varint(), ack = in.varint();
  const std::uint32_t before = in.u32();
  const std::uint64_t taken = in.varint();
  const std::uint64_t size = in.varint();
  const std::uint64_t at = size > 0 ? in.varint() : 0;
  if (!in.ok() || seq == 0 || seq > kSeqMost || ack > sent_ || size > in.left())
    return Error{"", "invalid packet"};
  if (!note(seq)) return ReceivedPacket{};
  const auto body = rest.last(in.left());
  acknowledge(ack, before, now);
  if (!sender_.taken(taken)) return Error{"", "a packet acknowledges texts that were never sent"};
  const Result<void> fits = receiver_.take(at, body.first(static_cast<std::size_t>(size)));
  if (!fits) return fits.error();
  return ReceivedPacket{true, seq, size > 0, body.subspan(static_cast<std::size_t>(size))};
}

bool DatagramChannel::note(Seq seq) {
  if (seq > newest_) {
    const Seq step = seq - newest_;
    before_ = step < 32 ? before_ << step : 0;
    if (newest_ > 0 && step <= 32) before_ |= 1u << (step - 1);
    newest_ = seq;
  } else {
    const Seq age = newest_ - seq;
    if (age == 0 || age >= kAcknowledged || (before_ >> (age - 1) & 1) != 0) return false;
    before_ |= 1u << (age - 1);
  }
  ++received_;
  return true;
}

void DatagramChannel::acknowledge(Seq ack, std::uint32_t before, double now) {
  std::erase_if(flights_, [&](const Flight& flight) {
    if (flight.seq > ack || ack - flight.seq >= kAcknowledged) return false;
    if (flight.seq == ack) round_trip_ += kSmoothing * (now - flight.time - round_trip_);
    if (flight.seq != ack && (before >> (ack - flight.seq - 1) & 1) == 0) return false;
    acknowledged_.push_back(flight.seq);
    return true;
  });
}

Settled DatagramChannel::settle(double now) {
  Settled settled;
  settled.acknowledged = std::exchange(acknowledged_, {});
  for (Flight& flight : flights_) {
    if (flight.is_lost || now - flight.time < patience()) continue;
    flight.is_lost = true;
    sender_.lost(flight.piece);
    settled.lost.push_back(flight.seq);
  }
  while (!flights_.empty() && now - flights_.front().time > kForgotten) flights_.pop_front();
  return settled;
}

}  // namespace playhouse::replicate
