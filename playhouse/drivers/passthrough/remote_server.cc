#include "playhouse/drivers/passthrough/remote_server.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "playhouse/base/limits.h"
#include "playhouse/base/log.h"
#include "playhouse/wire/codec.h"
#include "playhouse/wire/generated/player.h"

namespace playhouse::drivers {
namespace {

namespace player = wire::player;
using wire::MessageType;

constexpr RemoteDevice kServer{player::kCode, 0};
constexpr std::string_view kGreeting = "Player v.", kOwnName = "Playhouse";
constexpr std::uint8_t kPush = 1;                            // mode of DATAMODE
constexpr std::uint8_t kOpen = 1, kClose = 2, kEnded = 'e';  // access
constexpr std::size_t kUnderWay = limits::kSessionAnswerBytes;

std::vector<std::byte> access_request(RemoteDevice device, std::uint16_t port, std::uint8_t access) {
  return wire::encode(player::DeviceReq{{0, port, device.interf, device.index}, access, ""});
}

/// A refusal has the device, with access 3; without rights a request is not looked at.
RemoteServer::RemoteOpening opening_of(bool ack, std::span<const std::byte> body) {
  using RemoteOpening = RemoteServer::RemoteOpening;
  const Result<player::DeviceReq> told = wire::decode<player::DeviceReq>(body);
  if (ack && told && told->access == kOpen) return RemoteOpening::kOpen;
  return !ack && body.empty() ? RemoteOpening::kNotAdmitted : RemoteOpening::kNotOpen;
}

}  // namespace

std::string name_of_server(const std::string& host, std::uint16_t port) {
  return (host.find(':') == std::string::npos ? host : "[" + host + "]") + ":" + std::to_string(port);
}

RemoteServer::RemoteServer(net::Network& network, std::string host, std::uint16_t port,
                           RemoteServerEvents& events)
    : network_(network),
      host_(std::move(host)),
      port_(port),
      name_(name_of_server(host_, port)),
      events_(events) {}

void RemoteServer::set_server(std::string host, std::uint16_t port) {
  host_ = std::move(host);
  port_ = port;
  name_ = name_of_server(host_, port_);
}

void RemoteServer::set_token(std::string token) {
  token_ = std::move(token);
  token_for_ = name_;
}

void RemoteServer::connect() {
  if (connection_ || attempt_) return;
  const auto connected = [this](Result<std::unique_ptr<net::Connection>> connection) {
    made(std::move(connection));
  };
  attempt_ = trust_ ? network_.connect_tls(host_, port_, trust_, connected)
                    : network_.connect(host_, port_, connected);
}

void RemoteServer::made(Result<std::unique_ptr<net::Connection>> connection) {
  const std::unique_ptr<net::Attempt> done = std::move(attempt_);
  if (!connection) return fail(connection.error().text);
  connection_ = std::move(*connection);
  connection_->expect_alive();
  patience_ = network_.after(net::kConnectSeconds, [this] {
    fail(may_speak_tls() ? "sent no greeting, so it is not a Player server, or speaks TLS"
                         : "sent no greeting, so it is not a Player server");
  });
  connection_->start(*this);
}

void RemoteServer::disconnect() {
  attempt_.reset();
  if (connection_) connection_->close_after_flush();
  for (const ReplyHeard& heard : forget()) heard(false, {});
}

std::vector<RemoteServer::ReplyHeard> RemoteServer::forget() {
  connection_.reset();
  patience_.reset();
  greeted_ = false;
  input_.clear();
  held_.clear();
  waiting_ = 0;
  std::vector<ReplyHeard> unheard;
  for (auto& [key, all] : std::exchange(asked_, {}))
    for (Asked& asked : all) unheard.push_back(std::move(asked.heard));
  return unheard;
}

void RemoteServer::fail(const std::string& why) {
  for (const ReplyHeard& heard : forget()) heard(false, {});
  events_.lost(why);
}

void RemoteServer::closed(const std::string& why) {
  fail(why == "closed" ? "closed the connection" : why);
}

// --- input

void RemoteServer::received(std::span<const std::byte> bytes) {
  input_.insert(input_.end(), bytes.begin(), bytes.end());
  if (!greeted_ && !greet()) return fail("is not a Player server");
  if (greeted_) take_messages();
}

bool RemoteServer::greet() {
  const std::string_view text(reinterpret_cast<const char*>(input_.data()), input_.size());
  const std::size_t compared = std::min(text.size(), kGreeting.size());
  if (text.substr(0, compared) != kGreeting.substr(0, compared)) return false;
  if (text.size() < limits::kBannerBytes) return true;
  is_playhouse_ = text.substr(0, limits::kBannerBytes).find(kOwnName) != std::string_view::npos;
  input_.erase(input_.begin(), input_.begin() + limits::kBannerBytes);
  patience_.reset();
  greeted_ = true;
  if (has_token()) authenticate();
  request_of_server(player::kReqDatamode, wire::encode(player::DeviceDatamodeReq{kPush}), {});
  events_.connected();
  return true;
}

void RemoteServer::authenticate() {
  player::DeviceAuthReq key;
  key.auth_key.assign(token_.begin(), token_.end());
  request_of_server(player::kReqAuth, wire::encode(key), [this](bool ack, std::span<const std::byte>) {
    if (!ack && greeted_) log::warn("passthrough: {} refuses the token", name_);
  });
}

/// Handlers may close the connection, and clear the input.
void RemoteServer::take_messages() {
  std::size_t at = 0;
  while (greeted_ && input_.size() - at >= limits::kHeaderBytes) {
    const auto rest = std::span(std::as_const(input_)).subspan(at);
    const wire::Header header = wire::decode_header(rest.first<limits::kHeaderBytes>());
    if (header.size > limits::kBodyBytes)
      return fail(fmt::format("sent an invalid frame of {} bytes: up to {} are valid", header.size,
                              limits::kBodyBytes));
    if (rest.size() - limits::kHeaderBytes < header.size) break;
    const std::vector<std::byte> body(rest.begin() + limits::kHeaderBytes,
                                      rest.begin() + limits::kHeaderBytes + header.size);
    at += limits::kHeaderBytes + header.size;
    take(header, body);
  }
  if (!greeted_) return;
  input_.erase(input_.begin(), input_.begin() + static_cast<std::ptrdiff_t>(at));
  events_.caught_up();
}

void RemoteServer::take(const wire::Header& header, std::span<const std::byte> body) {
  switch (header.type) {
    case MessageType::kData:
      return events_.data({header.interf, header.index}, header, body);
    case MessageType::kAck:
    case MessageType::kNack:
      if (!tells_of_end(header, body)) take_answer(header, body);
      return;
    case MessageType::kCmd:
    case MessageType::kReq:
    case MessageType::kSynch:
      return;
  }
}

/// Unsolicited notice that an open device has retired (docs/server.md).
bool RemoteServer::tells_of_end(const wire::Header& header, std::span<const std::byte> body) {
  if (header.interf != player::kCode || header.subtype != player::kReqDev || header.type != MessageType::kAck)
    return false;
  const Result<player::DeviceReq> told = wire::decode<player::DeviceReq>(body);
  if (!told || told->access != kEnded) return false;
  events_.gone({told->addr.interf, told->addr.index});
  return true;
}

/// The original answers requests of one kind to one device in order: when a reply matches a later
/// request by its number, earlier ones will not be answered. This program answers each, in any order.
void RemoteServer::take_answer(const wire::Header& header, std::span<const std::byte> body) {
  const auto found = asked_.find({{header.interf, header.index}, header.subtype});
  if (found == asked_.end()) return;
  std::deque<Asked>& waiting = found->second;
  const auto meant = std::ranges::find(waiting, header.seq, &Asked::seq);
  const auto answered = meant == waiting.end() ? waiting.begin() : meant;
  std::vector<ReplyHeard> unanswered;
  const ReplyHeard heard = std::move(answered->heard);
  if (is_playhouse_) {
    waiting.erase(answered);
  } else {
    for (auto each = waiting.begin(); each != answered; ++each) unanswered.push_back(std::move(each->heard));
    waiting.erase(waiting.begin(), answered + 1);
  }
  waiting_ -= unanswered.size() + 1;
  if (waiting.empty()) asked_.erase(found);
  for (const ReplyHeard& each : unanswered)
    if (each) each(false, {});
  if (heard) heard(header.type == MessageType::kAck, body);
}

void RemoteServer::drained() {
  if (held_.empty() || !connection_) return;
  std::vector<net::SharedBytes> parts;
  for (auto& [key, bytes] : std::exchange(held_, {})) parts.push_back(std::move(bytes));
  connection_->send(parts);
}

// --- output

void RemoteServer::open(RemoteDevice device) {
  request_of_server(player::kReqDev, access_request(device, port_, kOpen),
                    [this, device](bool ack, std::span<const std::byte> body) {
                      if (!greeted_) return;
                      events_.opened(device, opening_of(ack, body));
                    });
}

void RemoteServer::close(RemoteDevice device) {
  send_held(device);
  request_of_server(player::kReqDev, access_request(device, port_, kClose), {});
}

void RemoteServer::request_of_server(std::uint8_t subtype, std::span<const std::byte> body,
                                     ReplyHeard heard) {
  ask(kServer, subtype, body, heard ? std::move(heard) : ReplyHeard([](bool, std::span<const std::byte>) {}));
}

void RemoteServer::ask(RemoteDevice device, std::uint8_t subtype, std::span<const std::byte> body,
                       ReplyHeard heard) {
  if (!greeted_ || waiting_ >= limits::kRequestQueue) return heard(false, {});
  ++seq_;
  asked_[{device, subtype}].push_back({seq_, std::move(heard)});
  ++waiting_;
  send_held(device);
  send(MessageType::kReq, device, subtype, body);
}

void RemoteServer::command(RemoteDevice device, std::uint8_t subtype, std::span<const std::byte> body) {
  if (greeted_) send(MessageType::kCmd, device, subtype, body);
}

/// Sends held commands of the device before a request or a close.
void RemoteServer::send_held(RemoteDevice device) {
  std::vector<net::SharedBytes> parts;
  std::erase_if(held_, [&](auto& held) {
    if (held.first.first != device) return false;
    parts.push_back(std::move(held.second));
    return true;
  });
  if (!parts.empty()) connection_->send(parts);
}

void RemoteServer::send(MessageType type, RemoteDevice device, std::uint8_t subtype,
                        std::span<const std::byte> body) {
  wire::Header header;
  header.robot = port_;
  header.interf = device.interf;
  header.index = device.index;
  header.type = type;
  header.subtype = subtype;
  header.seq = type == MessageType::kReq ? seq_ : 0;
  header.size = static_cast<std::uint32_t>(body.size());
  std::vector<std::byte> bytes(limits::kHeaderBytes);
  wire::encode_header(header, std::span<std::byte, limits::kHeaderBytes>(bytes.data(), limits::kHeaderBytes));
  bytes.insert(bytes.end(), body.begin(), body.end());
  net::SharedBytes shared = std::make_shared<const std::vector<std::byte>>(std::move(bytes));
  if (type == MessageType::kCmd && connection_->in_flight_bytes() > kUnderWay) {
    held_[{device, subtype}] = std::move(shared);
    return;
  }
  connection_->send(std::span(&shared, 1));
}

}  // namespace playhouse::drivers
