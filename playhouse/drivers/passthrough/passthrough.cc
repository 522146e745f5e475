#include "playhouse/drivers/passthrough/passthrough.h"

#include <fmt/format.h>
#include <sys/random.h>

#include <algorithm>
#include <utility>

#include "playhouse/base/assert.h"
#include "playhouse/base/in_quotes.h"
#include "playhouse/base/log.h"
#include "playhouse/base/packing.h"
#include "playhouse/device/device_table.h"
#include "playhouse/wire/auth_key.h"
#include "playhouse/wire/codec.h"
#include "playhouse/wire/generated/common.h"
#include "playhouse/wire/messages.h"

namespace playhouse::drivers {
namespace {

constexpr double kFirstWait = 0.5, kLongestWait = 30;  // s between attempts (back-off)
constexpr std::uint16_t kPlayerPort = 6665;            // default port of a remote host

std::string describe(RemoteDevice device) {
  const std::string whole = device::describe({0, device.interf, device.index});
  return whole.substr(whole.find(':') + 1);
}

/// Beyond every type of message, even where somebody reads its last byte alone.
constexpr std::uint32_t kMarked = 0x80000000, kTypeBits = 0xFF;

std::uint32_t random_mark() {
  std::uint32_t number = 0;
  PLAYHOUSE_ASSERT(getrandom(&number, sizeof number, 0) == sizeof number);
  return (number | kMarked) & ~kTypeBits;
}

/// CAPABILITIES, whose answer is NACK from every device: there is no such message.
wire::CapabilitiesReq circle_request(std::uint32_t mark, RemoteDevice device) {
  return {mark, static_cast<std::uint32_t>(device.interf) << 16 | device.index};
}

/// None if the request is another.
std::optional<wire::CapabilitiesReq> as_circle_request(const device::Message& message) {
  if (message.subtype != wire::kReqCapabilities) return std::nullopt;
  const Result<wire::CapabilitiesReq> asked = wire::decode<wire::CapabilitiesReq>(message.body);
  const bool is_one = asked && asked->type >= kMarked && (asked->type & kTypeBits) == 0;
  return is_one ? std::optional(*asked) : std::nullopt;
}

}  // namespace

Passthrough::Passthrough(Site& site, std::string host, std::uint16_t port, AfterLoss after_loss)
    : site_(site),
      after_loss_(after_loss),
      mark_(random_mark()),
      remote_(site.surroundings().network(), std::move(host), port, *this) {}

Result<void> Passthrough::add(device::Address address, RemoteDevice device) {
  const Result<device::DeviceId> id = site_.add_device(address, *this);
  if (!id) return id.error();
  here_[device] = *id;
  {
    const std::lock_guard lock(mutex_);
    relayed_[*id] = {address, device};
  }
  if (remote_.is_connected()) look_for_circle(device);
  return {};
}

std::optional<RemoteDevice> Passthrough::there(device::DeviceId id) const {
  const std::lock_guard lock(mutex_);
  const auto found = relayed_.find(id);
  return found == relayed_.end() ? std::nullopt : std::optional(found->second.there);
}

// --- from our clients; order is kept per device, whichever the thread

Result<void> Passthrough::start(device::DeviceId id) {
  if (!remote_.is_connected()) {
    if (retry_) retry_ = site_.surroundings().network().after(0, [this] { remote_.connect(); });
    return Error{"", remote_.name() + " " + why_lost_};
  }
  wanted_.insert(id);
  remote_.open(*there(id));
  return {};
}

void Passthrough::stop(device::DeviceId id) {
  if (wanted_.erase(id) == 0) return;
  const std::optional<RemoteDevice> device = there(id);
  // After earlier commands.
  site_.surroundings().post([this, id, device] {
    if (!wanted_.contains(id) && remote_.is_connected()) remote_.close(*device);
  });
}

void Passthrough::forget(device::DeviceId id) {
  const std::lock_guard lock(mutex_);
  const auto found = relayed_.find(id);
  if (found == relayed_.end()) return;
  here_.erase(found->second.there);
  relayed_.erase(found);
}

device::Taken Passthrough::command(const device::Message& message) {
  const std::optional<RemoteDevice> device = there(message.device);
  if (!device) return device::Taken::kNo;
  site_.surroundings().post(
      [this, device = *device, subtype = message.subtype,
       body = Bytes(message.body.begin(), message.body.end())] { remote_.command(device, subtype, body); });
  return device::Taken::kLatest;
}

void Passthrough::request(const device::Message& message, device::Replier replier) {
  const std::optional<RemoteDevice> device = there(message.device);
  if (!device) return;
  const std::optional<wire::CapabilitiesReq> circle = as_circle_request(message);
  if (circle == circle_request(mark_, *device)) return replier.ack({});
  auto shared = std::make_shared<device::Replier>(std::move(replier));  // std::function must be copyable
  site_.surroundings().post([this, shared, device = *device, subtype = message.subtype, circle,
                             body = Bytes(message.body.begin(), message.body.end())] {
    remote_.ask(device, subtype, body, [=, this](bool ack, std::span<const std::byte> answer) {
      Bytes bytes(answer.begin(), answer.end());
      ack ? shared->ack(std::move(bytes)) : shared->nack(std::move(bytes));
      if (ack && circle) end_circle(device);  // another's, which came back to it through this device
    });
  });
}

/// As far as known without asking the server.
bool Passthrough::capable(device::DeviceId id, std::uint8_t type, std::uint8_t subtype) const {
  const std::optional<RemoteDevice> device = there(id);
  return device &&
         wire::find_message(device->interf, static_cast<wire::MessageType>(type), subtype) != nullptr;
}

// --- from the server

void Passthrough::connected() {
  if (wait_ > 0) log::info("passthrough: {} is connected", remote_.name());
  retry_.reset();
  wait_ = 0;
  why_lost_.clear();
  for (const auto& [device, id] : here_) look_for_circle(device);
  for (const device::DeviceId id : wanted_) remote_.open(*there(id));
  if (watcher_.connected) watcher_.connected();
}

void Passthrough::look_for_circle(RemoteDevice device) {
  remote_.ask(device, wire::kReqCapabilities, wire::encode(circle_request(mark_, device)),
              [this, device](bool ack, std::span<const std::byte>) {
                if (ack) end_circle(device);
              });
}

void Passthrough::end_circle(RemoteDevice device) {
  const auto here = here_.find(device);
  if (here == here_.end()) return;
  device::Address address;
  {
    const std::lock_guard lock(mutex_);
    address = relayed_.at(here->second).address;
  }
  log::error("passthrough: {} leads back to itself by way of {}: it retires", site_.shown(address),
             remote_.name());
  site_.retire_later({address});
}

void Passthrough::lost(const std::string& why) {
  why_lost_ = why;
  if (watcher_.lost) return watcher_.lost(why);
  if (after_loss_ == AfterLoss::kConnect || !remote_.was_reached()) return connect_later();
  log::error("passthrough: {} {}: its devices retire", remote_.name(), why);
  std::vector<device::Address> devices;
  const std::lock_guard lock(mutex_);
  for (const auto& [id, relayed] : relayed_) devices.push_back(relayed.address);
  if (!devices.empty()) site_.retire_later(std::move(devices));
}

void Passthrough::connect_later() {
  if (wait_ == 0) log::warn("passthrough: {} {}: trying again", remote_.name(), why_lost_);
  wait_ = std::clamp(2 * wait_, kFirstWait, kLongestWait);
  retry_ = site_.surroundings().network().after(wait_, [this] { remote_.connect(); });
}

void Passthrough::data(RemoteDevice device, const wire::Header& header, std::span<const std::byte> body) {
  const auto here = here_.find(device);
  if (here == here_.end()) return;
  const wire::MessageDef* def = wire::find_message(device.interf, wire::MessageType::kData, header.subtype);
  const std::string wrong = def == nullptr ? std::string() : def->check(body);
  if (wrong.empty()) {
    batch_.push_back({here->second, header.subtype, header.timestamp, Bytes(body.begin(), body.end())});
  } else if (told_.insert(device).second) {
    log::warn("passthrough: {}: data of {} is left out: {}", remote_.name(), describe(device), wrong);
  }
}

void Passthrough::caught_up() {
  if (!batch_.empty()) site_.data_flow().publish(std::exchange(batch_, {}));
}

void Passthrough::refused(RemoteDevice device) {
  log::warn("passthrough: {} does not open {}", remote_.name(), describe(device));
}

void Passthrough::gone(RemoteDevice device) {
  caught_up();
  const auto here = here_.find(device);
  if (here != here_.end()) {
    const std::lock_guard lock(mutex_);
    site_.retire_later({relayed_.at(here->second).address});
  }
  if (watcher_.retired) watcher_.retired(device);
}

// --- sections of configuration files

namespace {

/// A parsed section.
struct Section {
  std::string host;
  std::uint16_t port = 0;
  std::vector<device::Address> here;
  std::vector<RemoteDevice> there;
};

/// The address as if it were on this server, with its port as the default.
Result<device::Address> resolved(const Site& site, scene::DeviceAddress address) {
  if (!address.host.empty() && !address.port) address.port = kPlayerPort;
  address.host.clear();
  return site.resolve(address);
}

bool is_this_machine(const std::string& host) {
  return host == "localhost" || host == "127.0.0.1" || host == "::1";
}

Result<Section> read_section(const scene::CfgSection& section, const Site& site) {
  const std::vector<scene::DeviceAddress> provided = section.addresses("provides");
  const std::vector<scene::DeviceAddress> required = section.addresses("requires");
  const std::string where = section.at("requires");
  if (required.empty())
    return Error{where,
                 "driver \"passthrough\" requires devices of another server, e.g. [\"lab:6665:laser:0\"]" +
                     section.slip_for("requires")};
  if (required.size() != provided.size())
    return Error{where, fmt::format("{} devices are provided and {} required: each stands for one",
                                    provided.size(), required.size())};
  Section read;
  for (std::size_t i = 0; i < required.size(); ++i) {
    const Result<device::Address> here = site.resolve(provided[i]);
    if (!here) return Error{section.at("provides"), here.error().text};
    const Result<device::Address> there = resolved(site, required[i]);
    if (!there) return Error{where, there.error().text};
    const std::string host = required[i].host.empty() ? "localhost" : required[i].host;
    const auto port = static_cast<std::uint16_t>(there->robot);
    if (here->interf != there->interf)
      return Error{where, fmt::format("{} cannot stand for {}: a passthrough changes no interface",
                                      in_quotes(provided[i].text()), in_quotes(required[i].text()))};
    if (i > 0 && (host != read.host || port != read.port))
      return Error{where, fmt::format("{} is of another server than {}: write a section for each",
                                      in_quotes(required[i].text()), in_quotes(required[0].text()))};
    if (is_this_machine(host) && *here == *there)
      return Error{where, fmt::format("{} would stand for itself", in_quotes(provided[i].text()))};
    read.host = host;
    read.port = port;
    const RemoteDevice device{there->interf, there->index};
    if (std::ranges::find(read.there, device) != read.there.end())
      return Error{where, fmt::format("{} is required twice", in_quotes(required[i].text()))};
    read.here.push_back(*here);
    read.there.push_back(device);
  }
  return read;
}

}  // namespace

Result<std::unique_ptr<device::Driver>> make_passthrough(const scene::CfgSection& section, Site& site) {
  const Result<Section> read = read_section(section, site);
  if (!read) return read.error();
  const auto after_loss =
      section.flag("reconnect", false) ? Passthrough::AfterLoss::kConnect : Passthrough::AfterLoss::kRetire;
  auto driver = std::make_unique<Passthrough>(site, read->host, read->port, after_loss);
  const std::string token = section.text("token", "");
  if (token.size() > wire::kAuthKeyBytes)
    return Error{section.at("token"), fmt::format("a token has {} letters at most", wire::kAuthKeyBytes)};
  driver->remote().set_token(token);
  for (std::size_t i = 0; i < read->here.size(); ++i)
    if (const Result<void> added = driver->add(read->here[i], read->there[i]); !added)
      return Error{section.at("provides"), added.error().text};
  // Deferred until the program runs, since the other server may be this program.
  site.surroundings().post([relay = driver.get()] { relay->connect(); });
  return std::unique_ptr<device::Driver>(std::move(driver));
}

Result<std::vector<std::unique_ptr<device::Driver>>> make_remote_devices(Site& site) {
  std::map<std::uint32_t, std::unique_ptr<Passthrough>> servers;
  for (const device::Address& address : site.take_remote_devices()) {
    std::unique_ptr<Passthrough>& server = servers[address.robot];
    if (server == nullptr)
      server = std::make_unique<Passthrough>(site, "localhost", static_cast<std::uint16_t>(address.robot),
                                             Passthrough::AfterLoss::kConnect);
    log::info("{} is taken from the server at {}", in_quotes(site.shown(address)), server->remote().name());
    if (const Result<void> added = server->add(address, {address.interf, address.index}); !added)
      return added.error();
  }
  std::vector<std::unique_ptr<device::Driver>> drivers;
  for (auto& [port, server] : servers) {
    site.surroundings().post([relay = server.get()] { relay->connect(); });
    drivers.push_back(std::move(server));
  }
  return drivers;
}

}  // namespace playhouse::drivers
