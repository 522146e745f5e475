#include "playhouse/replicate/datagrams/datagram_observer.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "playhouse/base/formats.h"
#include "playhouse/base/in_quotes.h"
#include "playhouse/base/limits.h"

namespace playhouse::replicate {
namespace {

constexpr double kAckPeriod = 0.025;      // s; acknowledgements are combined within it
constexpr std::uint32_t kAckAtOnce = 16;  // packets, of the 33 covered by an acknowledgement
constexpr double kSignOfLife = 0.5;       // s
constexpr double kLongestAsk = 2;         // s, longest retry interval
constexpr std::size_t kTextRoom = 1000;

}  // namespace

void DatagramObserver::receive(std::span<const std::byte> datagram, double now) {
  if (ended_) return;
  const Result<Datagram> parsed = parse_datagram(datagram);
  if (!parsed) return;  // from somebody else
  ++datagrams_;
  bytes_ += datagram.size();
  if (const auto* challenge = std::get_if<Challenge>(&*parsed)) take_challenge(*challenge);
  if (const auto* welcome = std::get_if<Welcome>(&*parsed)) {
    if (welcome->nonce == nonce_) heard_ = now;
    take_welcome(*welcome);
  }
  if (const auto* refusal = std::get_if<Refusal>(&*parsed))
    if (refusal->nonce == nonce_ && !channel_) ended_ = escaped(refusal->why);
  if (const auto* packet = std::get_if<PacketOf>(&*parsed)) take_packet(*packet, now);
  if (const auto* bye = std::get_if<Bye>(&*parsed))
    if (channel_ && bye->session == channel_->session()) ended_ = escaped(bye->why);
}

void DatagramObserver::take_challenge(const Challenge& challenge) {
  if (challenge.nonce != nonce_ || channel_ || cookie_ == challenge.cookie) return;
  cookie_ = challenge.cookie;
  asked_ = -1e9;  // retry at once
  asked_for_ = 0.25;
}

void DatagramObserver::take_welcome(const Welcome& welcome) {
  if (welcome.nonce != nonce_ || channel_) return;
  terms_ = welcome.terms;
  channel_.emplace(welcome.session, limits::kStreamTextBytes);
  for (auto& command : std::exchange(commands_, {})) channel_->post(std::move(command));
}

void DatagramObserver::take_packet(const PacketOf& packet, double now) {
  if (!channel_ || packet.session != channel_->session()) return;
  const Result<ReceivedPacket> heard = channel_->receive(packet.rest, now);
  if (!heard) {
    ended_ = heard.error().text;
    return;
  }
  if (!heard->is_new) return;
  heard_ = now;
  ++unacknowledged_;
  // Texts first: they introduce the models that states refer to.
  for (;;) {
    const Result<std::optional<ReceivedText>> text = channel_->next_text();
    if (text && !*text) break;
    const Result<void> taken = text ? world_.take_text((*text)->text, (*text)->after) : text.error();
    if (taken) continue;
    ended_ = taken.error().text;
    return;
  }
  if (const Result<void> taken = world_.take_state(heard->seq, heard->state); !taken)
    ended_ = taken.error().text;
}

std::optional<std::vector<std::byte>> DatagramObserver::next(double now) {
  if (ended_) return std::nullopt;
  if (now - heard_ >= limits::kObserverQuietSeconds) {
    ended_ = fmt::format("nothing was heard of it for {} s", limits::kObserverQuietSeconds);
    return std::nullopt;
  }
  if (!channel_) {
    if (now - asked_ < asked_for_) return std::nullopt;
    if (asked_ > 0) asked_for_ = std::min(2 * asked_for_, kLongestAsk);
    // Cookies expire within seconds: after a long wait start over.
    if (cookie_ && asked_for_ >= kLongestAsk) cookie_.reset();
    asked_ = now;
    if (!cookie_) return encode(Hello{formats::kObserver, nonce_});
    return encode(JoinRequest{formats::kObserver, nonce_, *cookie_, wanted_, token_});
  }
  static_cast<void>(channel_->settle(now));
  const bool due = unacknowledged_ >= kAckAtOnce ||
                   (now - sent_ >= kAckPeriod && (unacknowledged_ > 0 || channel_->texts().ready())) ||
                   now - sent_ >= kSignOfLife;
  if (!due) return std::nullopt;
  unacknowledged_ = 0;
  sent_ = now;
  std::vector<std::byte> packet;
  channel_->write(now, kTextRoom, packet);
  return packet;
}

void DatagramObserver::command(std::string_view text) {
  if (!channel_) {
    commands_.push_back(pack_text(text));
  } else {
    channel_->post(pack_text(text));
  }
}

std::optional<std::vector<std::byte>> DatagramObserver::bye() const {
  if (!channel_) return std::nullopt;
  return encode(Bye{channel_->session(), "left"});
}

}  // namespace playhouse::replicate
