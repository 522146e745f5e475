#include "playhouse_client/client.h"

#include <charconv>
#include <utility>

#include "playhouse/base/in_quotes.h"
#include "playhouse/wire/codec.h"
#include "playhouse/wire/generated/player.h"
#include "session.h"

namespace playhouse::client {

namespace player = wire::player;

namespace {

std::string driver_of(Session& session, const wire::Devaddr& device) {
  player::DeviceDriverinfo question;
  question.addr.interf = device.interf;
  question.addr.index = device.index;
  const auto answer = session.request(player::kCode, 0, player::kReqDriverinfo, wire::encode(question));
  if (!answer) return "";
  const auto named = wire::decode<player::DeviceDriverinfo>(*answer);
  return named ? std::string(wire::text(named->driver_name)) : "";
}

}  // namespace

std::string DeviceEntry::name() const {
  const wire::InterfaceDef* known = wire::find_interface(interf);
  return (known != nullptr ? std::string(known->name) : std::to_string(interf)) + ":" + std::to_string(index);
}

Result<Address> parse_address(std::string_view text) {
  Address address;
  const std::size_t bracket = text.starts_with('[') ? text.find(']') : std::string_view::npos;
  const bool ipv6 = bracket != std::string_view::npos;  // "[::1]:6665"
  const std::size_t colon = ipv6 ? text.find(':', bracket) : text.rfind(':');
  const std::string_view host = ipv6 ? text.substr(1, bracket - 1) : text.substr(0, colon);
  if (!host.empty()) address.host = host;
  if (colon == std::string_view::npos) return address;
  const std::string_view port = text.substr(colon + 1);
  const auto [end, fault] = std::from_chars(port.data(), port.data() + port.size(), address.port);
  if (fault != std::errc() || end != port.data() + port.size() || address.port == 0) {
    return Error{"", in_quotes(text) + " is not HOST or HOST:PORT"};
  }
  return address;
}

Result<Client> Client::connect(const std::string& host, std::uint16_t port, const Options& options) {
  Result<Connection> connection = Connection::open(host, port, deadline_after(options.timeout));
  if (!connection) return connection.error();
  Client made(std::make_shared<Session>(std::move(*connection), options));
  if (options.mode != Mode::kPush) {
    if (const Result<void> set = made.set_mode(options.mode); !set) return set.error();
  }
  return made;
}

Result<Client> Client::connect(std::string_view address, const Options& options) {
  const Result<Address> parsed = parse_address(address);
  if (!parsed) return parsed.error();
  return connect(parsed->host, parsed->port, options);
}

Client& Client::operator=(Client&& other) noexcept {
  std::swap(session_, other.session_);
  return *this;
}

Client::~Client() {
  if (session_) close();
}

const std::string& Client::banner() const {
  return session_->connection().banner();
}
const std::string& Client::peer() const {
  return session_->connection().peer();
}
bool Client::connected() const {
  return session_->connection().is_open();
}
std::uint64_t Client::overflow_count() const {
  return session_->overflow_count();
}
std::uint64_t Client::skipped_count() const {
  return session_->skipped_count();
}

Result<std::vector<DeviceEntry>> Client::devices() {
  const auto answer = session_->request(player::kCode, 0, player::kReqDevlist, {});
  if (!answer) return answer.error();
  const auto listed = wire::decode<player::DeviceDevlist>(*answer);
  if (!listed) return Error{peer(), "the device list does not decode: " + listed.error().text};
  std::vector<DeviceEntry> entries;
  for (const wire::Devaddr& device : listed->devices) {
    entries.push_back({device.interf, device.index, driver_of(*session_, device)});
    if (!connected()) return Error{peer(), "the server is gone"};
  }
  return entries;
}

Result<void> Client::set_mode(Mode mode) {
  return session_->set_mode(mode);
}

Result<void> Client::set_replace_rule(Rule rule, const RuleScope& scope) {
  player::AddReplaceRuleReq body;
  body.interf = scope.interf;
  body.index = scope.index;
  body.type = scope.type;
  body.subtype = scope.subtype;
  body.replace = static_cast<std::int32_t>(rule);
  const auto answer = session_->request(player::kCode, 0, player::kReqAddReplaceRule, wire::encode(body));
  return answer ? Result<void>() : answer.error();
}

Result<std::size_t> Client::read() {
  return session_->read(session_->timeout());
}
Result<std::size_t> Client::read(Seconds patience) {
  return session_->read(patience);
}

void Client::close() {
  session_->close();
}

}  // namespace playhouse::client
