#include "playhouse_client/client.h"

#include <algorithm>
#include <charconv>
#include <map>
#include <optional>
#include <utility>

#include "model_list.h"
#include "playhouse/base/in_quotes.h"
#include "playhouse/base/nearest_word.h"
#include "playhouse/wire/auth_key.h"
#include "playhouse/wire/codec.h"
#include "playhouse/wire/generated/common.h"
#include "playhouse/wire/generated/player.h"
#include "playhouse/wire/generated/simulation.h"
#include "playhouse_client/robot.h"
#include "session.h"

namespace playhouse::client {

namespace player = wire::player;

namespace {

/// The device list of the connection's port, in the server's order.
Result<std::vector<DeviceAddress>> list_devices(Session& session) {
  const auto answer = session.request(player::kCode, 0, player::kReqDevlist, {});
  if (!answer) return answer.error();
  const auto listed = wire::decode<player::DeviceDevlist>(*answer);
  if (!listed)
    return Error{session.connection().peer(), "the device list does not decode: " + listed.error().text};
  std::vector<DeviceAddress> devices;
  for (const wire::Devaddr& device : listed->devices)
    devices.push_back({device.robot, device.interf, device.index});
  return devices;
}

/// Maps each device to the row of its model. A device of several models maps to the last one.
std::map<DeviceAddress, std::size_t> models_by_device(const std::vector<Model>& models) {
  std::map<DeviceAddress, std::size_t> rows;
  for (std::size_t row = 0; row < models.size(); ++row) {
    for (const DeviceAddress& device : models[row].devices) rows[device] = row;
  }
  return rows;
}

/// Appends the devices of a model that are on this connection's port.
void append_devices(const Model& model, std::uint32_t port, std::vector<RobotDevice>& devices) {
  for (const DeviceAddress& device : model.devices) {
    if (device.port == port) devices.push_back({device, model.name});
  }
}

std::string driver_of(Session& session, const DeviceAddress& device) {
  player::DeviceDriverinfo question;
  question.addr.interf = device.interf;
  question.addr.index = device.index;
  const auto answer = session.request(player::kCode, 0, player::kReqDriverinfo, wire::encode(question));
  if (!answer) return "";
  const auto named = wire::decode<player::DeviceDriverinfo>(*answer);
  return named ? std::string(wire::text(named->driver_name)) : "";
}

}  // namespace

std::string DeviceAddress::name() const {
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
  if (!options.token.empty())
    if (const Result<void> admitted = made.authenticate(options.token); !admitted) return admitted.error();
  if (options.mode != Mode::kPush) {
    if (const Result<void> set = made.set_mode(options.mode); !set) return set.error();
  }
  return made;
}

Result<void> Client::authenticate(std::string_view token) {
  if (token.size() > wire::kAuthKeyBytes)
    return Error{peer(), "a token has " + std::to_string(wire::kAuthKeyBytes) + " letters at most"};
  const player::DeviceAuthReq key{{token.begin(), token.end()}};
  const auto answer = session_->request(player::kCode, 0, player::kReqAuth, wire::encode(key));
  if (answer) return {};
  if (!connected()) return answer.error();
  return Error{peer(), "the token is refused; a run without --guests needs none"};
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
  const Result<std::vector<DeviceAddress>> listed = list_devices(*session_);
  if (!listed) return listed.error();
  const Result<std::vector<Model>> told = told_models(*listed);
  if (!connected()) return Error{peer(), "the server is gone"};
  const std::vector<Model> models = told ? *told : std::vector<Model>();  // without it, names are empty
  const std::map<DeviceAddress, std::size_t> rows = models_by_device(models);
  std::vector<DeviceEntry> entries;
  for (const DeviceAddress& device : *listed) {
    DeviceEntry entry{device, driver_of(*session_, device), "", ""};
    if (!connected()) return Error{peer(), "the server is gone"};
    if (const auto row = rows.find(device); row != rows.end()) {
      entry.model = models[row->second].name;
      entry.robot = models[top_of(models, row->second)].name;
    }
    entries.push_back(std::move(entry));
  }
  return entries;
}

Result<std::vector<Model>> Client::models() {
  const Result<std::vector<DeviceAddress>> listed = list_devices(*session_);
  if (!listed) return listed.error();
  return told_models(*listed);
}

/// Requests the model list from the first simulation device.
Result<std::vector<Model>> Client::told_models(const std::vector<DeviceAddress>& devices) {
  const auto simulator = std::ranges::find(devices, wire::simulation::kCode, &DeviceAddress::interf);
  if (simulator == devices.end())
    return Error{peer(), "the server tells no names: it has no simulation device"};
  std::optional<Device> opened;  // an open device is not reopened: that would change its access
  if (!session_->has_open(simulator->interf, simulator->index)) {
    Result<Device> device = Device::open(*this, simulator->interf, simulator->index, Access::kRead);
    if (!device) return device.error();
    opened.emplace(std::move(*device));
  }
  auto told = ask_models(*session_, simulator->index);
  if (!told) return Error{peer(), told.error().text};
  if (!*told) return Error{peer(), "the server tells no names of models"};
  return std::move(**told);
}

Result<std::vector<Robot>> Client::robots() {
  const Result<std::vector<DeviceAddress>> listed = list_devices(*session_);
  if (!listed) return listed.error();
  const Result<std::vector<Model>> models = told_models(*listed);
  if (!models) return models.error();
  std::vector<std::vector<RobotDevice>> carried(models->size());
  for (std::size_t row = 0; row < models->size(); ++row)
    append_devices((*models)[row], listed->front().port, carried[top_of(*models, row)]);
  std::vector<Robot> robots;
  for (std::size_t row = 0; row < models->size(); ++row) {
    if (!carried[row].empty())
      robots.push_back(Robot(session_, (*models)[row].name, (*models)[row].type, std::move(carried[row])));
  }
  return robots;
}

Result<Robot> Client::robot(std::string_view name) {
  const Result<std::vector<DeviceAddress>> listed = list_devices(*session_);
  if (!listed) return listed.error();
  const Result<std::vector<Model>> models = told_models(*listed);
  if (!models) return models.error();
  const auto found =
      std::find_if(models->rbegin(), models->rend(), [&](const Model& model) { return model.name == name; });
  if (found == models->rend()) {
    std::vector<std::string_view> names;
    for (const Model& model : *models) names.push_back(model.name);
    return Error{peer(), "there is no robot " + in_quotes(name) + did_you_mean(name, names)};
  }
  const auto row = static_cast<std::size_t>(models->rend() - found) - 1;
  std::vector<bool> is_part(models->size());
  is_part[row] = true;
  std::vector<RobotDevice> devices;
  for (std::size_t part = row; part < models->size(); ++part) {
    const Model& model = (*models)[part];
    if (model.parent && is_part[*model.parent]) is_part[part] = true;
    if (is_part[part]) append_devices(model, listed->front().port, devices);
  }
  return Robot(session_, found->name, found->type, std::move(devices));
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

Result<std::uint64_t> Client::lost_count() {
  const wire::IntpropReq question{wire::c_string("lost"), 0};
  const auto answer = session_->request(player::kCode, 0, wire::kReqGetIntprop, wire::encode(question));
  if (!answer) return answer.error();
  const auto told = wire::decode<wire::IntpropReq>(*answer);
  if (!told) return Error{peer(), "the number of lost messages does not decode: " + told.error().text};
  return static_cast<std::uint64_t>(std::max(told->value, 0)) + session_->unread_count();
}

void Client::close() {
  session_->close();
}

}  // namespace playhouse::client
