#include "playhouse/drivers/passthrough/passthrough.h"

#include <fmt/format.h>
#include <sys/random.h>

#include <algorithm>
#include <initializer_list>
#include <iterator>
#include <limits>
#include <utility>

#include "playhouse/base/assert.h"
#include "playhouse/base/in_quotes.h"
#include "playhouse/base/limits.h"
#include "playhouse/base/log.h"
#include "playhouse/base/packing.h"
#include "playhouse/config/text/source_text.h"
#include "playhouse/device/device_table.h"
#include "playhouse/drivers/back_off.h"
#include "playhouse/net/tls/tls_trust.h"
#include "playhouse/wire/auth_key.h"
#include "playhouse/wire/codec.h"
#include "playhouse/wire/generated/common.h"
#include "playhouse/wire/messages.h"

namespace playhouse::drivers {
namespace {

constexpr double kLinger = 1;  // s that what nobody uses any more stays open
constexpr const char* kNotConnected = "is not connected";
constexpr const char* kHasRetired = "the device has retired";
constexpr std::uint16_t kPlayerPort = 6665;                                // default port of a remote host
constexpr int kLargestNumber = std::numeric_limits<std::uint16_t>::max();  // of ports and of devices

std::string describe(RemoteDevice device) {
  return device::describe_on_port({0, device.interf, device.index});
}

/// Clients see where a device comes from, within what they have room for.
std::string driver_name(const std::string& host, std::uint16_t port) {
  return ("passthrough (" + name_of_server(host, port) + ")").substr(0, limits::kDriverNameBytes - 1);
}

/// Beyond every type of message, even where somebody reads its last byte alone; the bits above that byte count the
/// servers that have passed it on.
constexpr std::uint32_t kMarked = 0x80000000, kTypeBits = 0xFF, kHop = 0x100, kHopBits = 0xF00;
static_assert(limits::kRelayHops * kHop <= kHopBits);

/// In the NACK of a look that did not get to the end of its way, which may be a circle.
constexpr std::size_t kNotReachedBytes = 1;

std::uint32_t random_mark() {
  std::uint32_t number = 0;
  PLAYHOUSE_ASSERT(getrandom(&number, sizeof number, 0) == sizeof number);
  return (number | kMarked) & ~(kTypeBits | kHopBits);
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

constexpr PropertyText kRemoteProperties[] = {
    {"remote_host", "string",
     "The other server's machine; setting it changes what all devices of the section stand for."},
    {"remote_port", "int", "Its port."},
    {"remote_index", "int", "Index of the device there that this one stands for."},
    {"connect", "int", "0: disconnected until it is 1 again, the whole section."},
};
constexpr std::string_view kHost = kRemoteProperties[0].name, kPort = kRemoteProperties[1].name,
                           kIndex = kRemoteProperties[2].name, kConnect = kRemoteProperties[3].name;

/// Of a request for a property of the proxy itself: whether it sets it. None if the request is another.
std::optional<bool> own_property(const device::Message& message) {
  const auto is_ours = [](const auto& asked, std::initializer_list<std::string_view> keys) {
    return asked && std::ranges::find(keys, wire::text(asked->key)) != keys.end();
  };
  switch (message.subtype) {
    case wire::kReqGetStrprop:
    case wire::kReqSetStrprop:
      if (!is_ours(wire::decode<wire::StrpropReq>(message.body), {kHost})) return std::nullopt;
      return message.subtype == wire::kReqSetStrprop;
    case wire::kReqGetIntprop:
    case wire::kReqSetIntprop:
      if (!is_ours(wire::decode<wire::IntpropReq>(message.body), {kPort, kIndex, kConnect}))
        return std::nullopt;
      return message.subtype == wire::kReqSetIntprop;
    default:
      return std::nullopt;
  }
}

/// Whether a property of the proxy may have a value.
bool is_valid(std::string_view key, std::int32_t value) {
  return value >= (key == kPort ? 1 : 0) && value <= kLargestNumber;
}

}  // namespace

Passthrough::Passthrough(Site& site, std::string host, std::uint16_t port, AfterLoss after_loss)
    : site_(site),
      name_(driver_name(host, port)),
      after_loss_(after_loss),
      mark_(random_mark()),
      remote_(site.surroundings().network(), std::move(host), port, *this),
      why_lost_(kNotConnected) {}

Result<void> Passthrough::add(device::Address address, RemoteDevice device) {
  const Result<device::DeviceId> id = site_.add_device(address, *this);
  if (!id) return id.error();
  Proxy& proxy = proxies_[device];
  proxy.here = *id;
  proxy.address = address;
  const std::lock_guard lock(mutex_);
  relayed_[*id] = device;
  return {};
}

void Passthrough::connect() {
  stays_connected_ = true;
  remote_.connect();
}

std::optional<RemoteDevice> Passthrough::there(device::DeviceId id) const {
  const std::lock_guard lock(mutex_);
  const auto found = relayed_.find(id);
  return found == relayed_.end() ? std::nullopt : std::optional(found->second);
}

// --- from our clients; order is kept per device, whichever the thread

bool Passthrough::ready(device::DeviceId id) const {
  const std::optional<RemoteDevice> device = there(id);
  return device && remote_.is_connected() && proxies_.at(*device).is_open();
}

/// Deferred: before the program runs nobody listens at its own ports, which may be the other server's.
void Passthrough::prepare(device::DeviceId id, Prepared heard) {
  site_.surroundings().post([this, id, heard = std::move(heard)] {
    const std::optional<RemoteDevice> device = there(id);
    device ? when_open(*device, heard) : heard(Error{"", kHasRetired});
  });
}

Result<void> Passthrough::start(device::DeviceId id) {
  if (!ready(id))
    return Error{"", remote_.name() + (remote_.is_connected() ? " has not opened it" : " " + why_lost_)};
  proxies_.at(*there(id)).is_wanted = true;
  return {};
}

void Passthrough::stop(device::DeviceId id) {
  const std::optional<RemoteDevice> device = there(id);
  if (!device || !std::exchange(proxies_.at(*device).is_wanted, false)) return;
  // After earlier commands.
  site_.surroundings().post([this, device = *device] {
    if (const auto found = proxies_.find(device); found != proxies_.end())
      close_if_idle(device, found->second);
    tidy_later();
  });
}

void Passthrough::forget(device::DeviceId id) {
  const std::optional<RemoteDevice> device = there(id);
  if (!device) return;
  {
    const std::lock_guard lock(mutex_);
    relayed_.erase(id);
  }
  Proxies::node_type node = proxies_.extract(*device);
  close_if_idle(*device, node.mapped());
  refuse(node.mapped(), kHasRetired);
  tidy_later();
}

device::Taken Passthrough::command(const device::Message& message) {
  const std::optional<RemoteDevice> device = there(message.device);
  if (!device) return device::Taken::kNo;
  site_.surroundings().post([this, device = *device, subtype = message.subtype,
                             body = Bytes(message.body.begin(), message.body.end())] {
    when_reached(device, [this, device, subtype, body](const Result<void>& open) {
      if (open) remote_.command(device, subtype, body);
    });
  });
  return device::Taken::kLatest;
}

void Passthrough::request(const device::Message& message, device::Replier replier) {
  const std::optional<RemoteDevice> device = there(message.device);
  if (!device) return;
  auto shared = std::make_shared<device::Replier>(std::move(replier));  // std::function must be copyable
  if (const std::optional<wire::CapabilitiesReq> look = as_circle_request(message))
    return site_.surroundings().post(
        [this, device = *device, look = *look, shared] { pass_look_on(device, look, std::move(*shared)); });
  if (const std::optional<bool> sets = own_property(message)) {
    if (*sets && message.caller != nullptr && !message.caller->rights().manages) return;
    return site_.surroundings().post([this, shared, id = message.device, subtype = message.subtype,
                                      body = Bytes(message.body.begin(), message.body.end())] {
      const std::optional<RemoteDevice> now = there(id);
      if (std::optional<Bytes> answer = now ? answer_property(*now, subtype, body) : std::nullopt)
        shared->ack(std::move(*answer));
    });
  }
  site_.surroundings().post([this, shared, device = *device, subtype = message.subtype,
                             body = Bytes(message.body.begin(), message.body.end())] {
    when_reached(device, [this, shared, device, subtype, body](const Result<void>& open) {
      if (!open) return;
      ++under_way_;
      remote_.ask(device, subtype, body, [this, shared](bool ack, std::span<const std::byte> answer) {
        --under_way_;
        Bytes bytes(answer.begin(), answer.end());
        ack ? shared->ack(std::move(bytes)) : shared->nack(std::move(bytes));
      });
    });
  });
}

/// As far as known without asking the server.
bool Passthrough::capable(device::DeviceId id, std::uint8_t type, std::uint8_t subtype) const {
  const std::optional<RemoteDevice> device = there(id);
  return device &&
         wire::find_message(device->interf, static_cast<wire::MessageType>(type), subtype) != nullptr;
}

/// Whoever waits is answered while he is there.
void Passthrough::finish() {
  retry_.reset();
  tidy_.reset();
  remote_.disconnect();
  for (auto& [device, proxy] : proxies_) refuse(proxy, "the program ends");
  callers_.clear();
}

// --- what devices wait for

void Passthrough::when_open(RemoteDevice device, Prepared then) {
  Proxy& proxy = proxies_.at(device);
  if (!proxy.is_wanted) tidy_later();
  if (proxy.is_open()) return then({});
  if (is_over()) return then(Error{"", remote_.name() + " " + why_lost_});
  if (proxy.circle) return then(Error{"", "it " + proxy.told});
  if (proxy.openers.size() >= limits::kRelayWaiting) return then(Error{"", "too many wait for it"});
  proxy.openers.push_back(std::move(then));
  wait_at(device, proxy);
}

/// For messages, which clients send without opening the device: it is open there for them as well, since what leads
/// in a circle is never open, and nothing goes round. Those to a device that is open here wait for no lost server.
void Passthrough::when_reached(RemoteDevice device, Prepared then) {
  const auto found = proxies_.find(device);
  if (found == proxies_.end()) return then(Error{"", kHasRetired});
  if (stays_connected_ && remote_.is_connected()) return then({});
  const Proxy& proxy = found->second;
  if (proxy.is_wanted && !proxy.is_open()) return then(Error{"", "it is not open there"});
  when_open(device, std::move(then));
}

void Passthrough::when_connected(Prepared then) {
  tidy_later();
  if (remote_.is_connected()) return then({});
  if (is_over() || callers_.size() >= limits::kRelayWaiting) return then(Error{"", "it is not connected"});
  callers_.push_back(std::move(then));
  retry_.reset();
  remote_.connect();
}

void Passthrough::wait_at(RemoteDevice device, Proxy& proxy) {
  if (!proxy.patience)
    proxy.patience = site_.surroundings().network().after(limits::kRelaySeconds, [this, device] {
      const auto found = proxies_.find(device);
      if (found != proxies_.end()) refuse(found->second, why_silent());
    });
  if (remote_.is_connected()) return advance(device, proxy);
  retry_.reset();
  remote_.connect();
}

/// Says what there is to be said to the server, with a connection.
void Passthrough::advance(RemoteDevice device, Proxy& proxy) {
  if (proxy.is_idle()) return;
  if (proxy.way == Proxy::Way::kUnknown) look_for_circle(device, proxy);
  if (proxy.there != Proxy::There::kClosed) return;
  proxy.there = Proxy::There::kAsked;
  remote_.open(device);
}

/// A request that comes back here if the device leads in a circle. The original's servers are not asked: some of
/// their drivers end with such a request. In a circle with one of them nothing is ever open.
void Passthrough::look_for_circle(RemoteDevice device, Proxy& proxy) {
  if (!remote_.is_playhouse()) {
    proxy.way = Proxy::Way::kFree;
    return settle(proxy);
  }
  proxy.way = Proxy::Way::kAsked;
  remote_.ask(device, wire::kReqCapabilities, wire::encode(circle_request(mark_, device)),
              [this, device](bool ack, std::span<const std::byte> why) {
                const auto found = proxies_.find(device);
                if (!remote_.is_connected() || found == proxies_.end()) return;
                Proxy& proxy = found->second;
                if (ack) return meet_circle(device, proxy);
                const bool is_reached = why.size() != kNotReachedBytes;
                proxy.way = is_reached ? Proxy::Way::kFree : Proxy::Way::kUnknown;
                is_reached ? settle(proxy) : refuse(proxy, remote_.name() + " does not reach it");
              });
}

/// Another's look, or ours that has come back.
void Passthrough::pass_look_on(RemoteDevice device, wire::CapabilitiesReq look, device::Replier replier) {
  const std::uint32_t hops = look.type & kHopBits;
  const bool is_ours = look.type - hops == mark_ && look.subtype == circle_request(mark_, device).subtype;
  if (is_ours || hops >= limits::kRelayHops * kHop) return replier.ack();
  look.type += kHop;
  auto shared = std::make_shared<device::Replier>(std::move(replier));
  when_connected([this, device, look, shared](const Result<void>& there) {
    if (!there) return shared->nack(Bytes(kNotReachedBytes));
    if (!remote_.is_playhouse()) return;
    ++under_way_;
    remote_.ask(
        device, wire::kReqCapabilities, wire::encode(look),
        [this, shared](bool ack, std::span<const std::byte> why) {
          --under_way_;
          if (ack) return shared->ack();
          shared->nack(remote_.is_connected() ? Bytes(why.begin(), why.end()) : Bytes(kNotReachedBytes));
        });
  });
}

void Passthrough::meet_circle(RemoteDevice device, Proxy& proxy) {
  const std::string why = fmt::format("leads in a circle by way of {}, or through more than {} servers",
                                      remote_.name(), limits::kRelayHops);
  if (std::exchange(proxy.told, why) != why)
    log::error("passthrough: {} {}: it cannot be opened", site_.shown(proxy.address), why);
  proxy.way = Proxy::Way::kUnknown;
  // An open that goes round, with its refusals behind it, ends here; later whoever opens it looks again.
  proxy.circle = site_.surroundings().network().after(limits::kRelaySeconds, [this, device] {
    if (const auto found = proxies_.find(device); found != proxies_.end()) found->second.circle.reset();
  });
  if (std::exchange(proxy.there, Proxy::There::kClosed) == Proxy::There::kOpen) remote_.close(device);
  refuse(proxy, "it " + why);
  if (proxy.is_wanted) try_later();
}

/// Tells those whose wait is over.
void Passthrough::settle(Proxy& proxy) {
  if (!proxy.is_open()) return;
  proxy.told.clear();
  proxy.patience.reset();
  for (const Prepared& heard : std::exchange(proxy.openers, {})) heard({});
}

void Passthrough::refuse(Proxy& proxy, const std::string& why) {
  proxy.patience.reset();
  for (const Prepared& heard : std::exchange(proxy.openers, {})) heard(Error{"", why});
}

std::string Passthrough::why_silent() const {
  return fmt::format("{} does not answer within {:g} s{}", remote_.name(), limits::kRelaySeconds,
                     remote_.may_speak_tls() ? "; if it speaks TLS, tls_ca says whom to trust" : "");
}

std::string Passthrough::why_closed(RemoteDevice device, RemoteServer::RemoteOpening opening) const {
  const std::string why = fmt::format("{} does not open {}", remote_.name(), describe(device));
  if (opening != RemoteServer::RemoteOpening::kNotAdmitted) return why;
  return why + (remote_.has_token() ? ": the token does not admit this" : ": it may need a token");
}

void Passthrough::close_if_idle(RemoteDevice device, Proxy& proxy) {
  if (!proxy.is_idle() || proxy.there != Proxy::There::kOpen) return;
  proxy.there = Proxy::There::kClosed;
  remote_.close(device);
}

void Passthrough::tidy_later() {
  tidy_ = site_.surroundings().network().after(kLinger, [this] { tidy(); });
}

/// Closes what nobody has started after all, and the connection that nobody uses.
void Passthrough::tidy() {
  bool is_wanted = stays_connected_, is_idle = under_way_ == 0 && callers_.empty();
  for (auto& [device, proxy] : proxies_) {
    close_if_idle(device, proxy);
    is_wanted |= proxy.is_wanted;
    is_idle &= proxy.is_idle();
  }
  if (is_wanted) return;
  is_idle ? disconnect() : tidy_later();
}

/// What is known of it holds for one connection.
void Passthrough::forget_server() {
  for (auto& [device, proxy] : proxies_) {
    proxy.way = Proxy::Way::kUnknown;
    proxy.there = Proxy::There::kClosed;
  }
}

void Passthrough::try_later() {
  if (retry_) return;
  wait_ = next_wait(wait_);
  retry_ = site_.surroundings().network().after(wait_, [this] {
    retry_.reset();
    remote_.is_connected() ? advance_all() : remote_.connect();
  });
}

void Passthrough::advance_all() {
  for (auto& [device, proxy] : proxies_) advance(device, proxy);
}

// --- properties of the proxies

/// None: NACK.
std::optional<Bytes> Passthrough::answer_property(RemoteDevice device, std::uint8_t subtype,
                                                  const Bytes& body) {
  if (subtype == wire::kReqGetStrprop || subtype == wire::kReqSetStrprop)
    return answer_host(*wire::decode<wire::StrpropReq>(body), subtype == wire::kReqSetStrprop);
  return answer_number(device, *wire::decode<wire::IntpropReq>(body), subtype == wire::kReqSetIntprop);
}

std::optional<Bytes> Passthrough::answer_host(wire::StrpropReq asked, bool sets) {
  if (sets) {
    const std::string host(wire::text(asked.value));
    if (host.empty() || stays_connected_) return std::nullopt;
    move_to(host, remote_.port());
  }
  asked.value = wire::c_string(remote_.host());
  return wire::encode(asked);
}

std::optional<Bytes> Passthrough::answer_number(RemoteDevice device, wire::IntpropReq asked, bool sets) {
  const std::string_view key = wire::text(asked.key);
  if (sets && (stays_connected_ || !is_valid(key, asked.value))) return std::nullopt;
  const auto value = static_cast<std::uint16_t>(asked.value);
  if (sets && key == kPort) move_to(remote_.host(), value);
  if (sets && key == kIndex && !move_proxy(device, value)) return std::nullopt;
  if (sets && key == kConnect) set_connected(asked.value != 0);
  if (!sets) asked.value = key == kPort ? remote_.port() : key == kIndex ? device.index : is_cut_ ? 0 : 1;
  return wire::encode(asked);
}

/// The devices of another server from now on.
void Passthrough::move_to(const std::string& host, std::uint16_t port) {
  if (host == remote_.host() && port == remote_.port()) return;
  disconnect();
  for (auto& [device, proxy] : proxies_) proxy.circle.reset();
  remote_.set_server(host, port);
  name_ = driver_name(host, port);
  log::info("passthrough: its devices are those of {}, which gets {}token", remote_.name(),
            remote_.has_token() ? "the file's " : "no ");
  set_connected(!is_cut_);
}

/// Another device of the server. False if it has a proxy already.
bool Passthrough::move_proxy(RemoteDevice from, std::uint16_t index) {
  if (index == from.index) return true;
  const RemoteDevice to{from.interf, index};
  if (proxies_.contains(to)) return false;
  Proxies::node_type node = proxies_.extract(from);
  Proxy& proxy = node.mapped();
  if (proxy.there == Proxy::There::kOpen) remote_.close(from);
  refuse(proxy, "another device takes its place");
  proxy.way = Proxy::Way::kUnknown;
  proxy.there = Proxy::There::kClosed;
  proxy.patience.reset();
  proxy.circle.reset();  // these are of the old device
  {
    const std::lock_guard lock(mutex_);
    relayed_[proxy.here] = to;
  }
  node.key() = to;
  proxies_.insert(std::move(node));
  if (remote_.is_connected()) advance(to, proxies_.at(to));
  return true;
}

/// Connects if somebody has a device open, or disconnects until further notice.
void Passthrough::set_connected(bool connects) {
  is_cut_ = !connects;
  if (is_cut_) return disconnect();
  const auto is_wanted = [](const auto& entry) { return entry.second.is_wanted; };
  if (std::ranges::any_of(proxies_, is_wanted)) remote_.connect();
}

void Passthrough::disconnect() {
  retry_.reset();
  wait_ = 0;
  remote_.disconnect();
  why_lost_ = kNotConnected;
  forget_server();
  for (const Prepared& heard : std::exchange(callers_, {})) heard(Error{"", kNotConnected});
  for (auto& [device, proxy] : proxies_) refuse(proxy, remote_.name() + " " + kNotConnected);
}

// --- from the server

void Passthrough::connected() {
  if (wait_ > 0) log::info("passthrough: {} is connected", remote_.name());
  retry_.reset();
  wait_ = 0;
  for (const Prepared& heard : std::exchange(callers_, {})) heard({});
  advance_all();
  if (watcher_.connected) watcher_.connected();
}

void Passthrough::lost(const std::string& why) {
  why_lost_ = why;
  forget_server();
  for (const Prepared& heard : std::exchange(callers_, {})) heard(Error{"", why});
  for (auto& [device, proxy] : proxies_) refuse(proxy, remote_.name() + " " + why);
  if (watcher_.lost) return watcher_.lost(why);
  const auto is_wanted = [](const auto& entry) { return entry.second.is_wanted; };
  if (std::ranges::none_of(proxies_, is_wanted)) return;
  if (after_loss_ == AfterLoss::kRetire) return retire_all();
  if (wait_ == 0) log::warn("passthrough: {} {}: trying again", remote_.name(), why);
  try_later();
}

void Passthrough::retire_all() {
  log::error("passthrough: {} {}: its devices retire", remote_.name(), why_lost_);
  std::vector<device::Address> devices;
  for (const auto& [device, proxy] : proxies_) devices.push_back(proxy.address);
  site_.retire_later(std::move(devices));
}

void Passthrough::opened(RemoteDevice device, RemoteServer::RemoteOpening opening) {
  const bool is_open = opening == RemoteServer::RemoteOpening::kOpen;
  const auto found = proxies_.find(device);
  if (found == proxies_.end()) {
    if (is_open) remote_.close(device);  // it has retired here
    return;
  }
  Proxy& proxy = found->second;
  proxy.there = is_open ? Proxy::There::kOpen : Proxy::There::kClosed;
  if (is_open) return settle(proxy);
  const std::string why = why_closed(device, opening);
  refuse(proxy, why);
  if (!proxy.is_wanted) return;
  if (std::exchange(proxy.told, why) != why) log::warn("passthrough: {}: trying again", why);
  try_later();
}

void Passthrough::data(RemoteDevice device, const wire::Header& header, std::span<const std::byte> body) {
  const auto found = proxies_.find(device);
  if (found == proxies_.end()) return;
  const wire::MessageDef* def = wire::find_message(device.interf, wire::MessageType::kData, header.subtype);
  const std::string wrong = def == nullptr ? std::string() : def->check(body);
  if (wrong.empty()) {
    batch_.push_back({found->second.here, header.subtype, header.timestamp, Bytes(body.begin(), body.end())});
  } else if (told_.insert(device).second) {
    log::warn("passthrough: {}: data of {} is left out: {}", remote_.name(), describe(device), wrong);
  }
}

void Passthrough::caught_up() {
  if (!batch_.empty()) site_.data_flow().publish(std::exchange(batch_, {}));
}

void Passthrough::gone(RemoteDevice device) {
  caught_up();
  if (const auto found = proxies_.find(device); found != proxies_.end()) {
    found->second.there = Proxy::There::kClosed;
    site_.retire_later({found->second.address});
  }
  if (watcher_.retired) watcher_.retired(device);
}

// --- sections of configuration files

namespace {

constexpr DeviceText kPassthroughProvides[] = {
    {{}, {}, HowMany::kAny, "the first stands for the first of requires, and so on"}};
constexpr DeviceText kPassthroughUses[] = {
    {{}, {}, HowMany::kAny, "of one other server, as lab:6665:laser:0"}};

struct PassthroughOptions {
  Passthrough::AfterLoss after_loss;
  bool connects;
  std::string token;
  std::string tls_ca;  // file; empty: in the clear
  // In place of what `requires` says, where the section has them.
  std::string remote_host;
  std::uint16_t remote_port;
  std::vector<int> remote_indices;
};

Result<PassthroughOptions> passthrough_options(SectionFields fields) {
  const std::string host = fields.text(
      {kHost, "The other server's machine, in place of that of requires.", {}, "that of requires"});
  const int port = fields.integer({kPort, "Its port, in place of that of requires.", {}, "that of requires"},
                                  kPlayerPort, 1, kLargestNumber);
  const std::vector<int> indices = fields.integers(
      {kIndex, "Indices of the devices there, one for each, in place of those of requires; none: those."});
  const auto is_index = [](int index) { return index >= 0 && index <= kLargestNumber; };
  fields.expect(std::ranges::all_of(indices, is_index), kIndex,
                fmt::format("is from 0 to {}", kLargestNumber));
  const bool connects =
      fields.flag({kConnect, "0: disconnected until a client sets the property of that name to 1."}, true);
  const bool waits = fields.flag(
      {"reconnect", "0: the devices retire when the connection is lost, instead of waiting for the server."},
      true);
  std::string token = fields.text(
      {"token",
       "That of a guest, for a server with --guests or --key; sent to the server of the file alone.",
       {},
       "none"});
  fields.expect(token.size() <= wire::kAuthKeyBytes, "token",
                fmt::format("has {} letters at most", wire::kAuthKeyBytes));
  std::string tls_ca = fields.filename(
      {"tls_ca", "Certificates to trust, PEM, for a server with --tls-cert: its own, or its authority's."});
  if (const Result<void> fault = fields.fault(); !fault) return fault.error();
  return PassthroughOptions{waits ? Passthrough::AfterLoss::kConnect : Passthrough::AfterLoss::kRetire,
                            connects,
                            std::move(token),
                            std::move(tls_ca),
                            host,
                            static_cast<std::uint16_t>(port),
                            indices};
}

Result<std::shared_ptr<net::TlsTrust>> read_trust(const config::CfgSection& section,
                                                  const std::string& file) {
  if (file.empty()) return std::shared_ptr<net::TlsTrust>();
  const Result<std::string> text = config::DiskFiles().read(file);
  if (!text) return Error{section.at("tls_ca"), text.error().line()};
  Result<std::shared_ptr<net::TlsTrust>> trust = net::TlsTrust::of({file, *text});
  if (!trust) return Error{section.at("tls_ca"), trust.error().line()};
  return trust;
}

/// A parsed section.
struct Section {
  std::string host;
  std::uint16_t port = 0;
  std::vector<device::Address> here;
  std::vector<RemoteDevice> there;
};

/// The address as if it were on this server, with its port as the default.
Result<device::Address> resolved(const Site& site, config::DeviceAddress address) {
  if (!address.host.empty() && !address.port) address.port = kPlayerPort;
  address.host.clear();
  return site.resolve(address);
}

bool is_this_machine(const std::string& host) {
  return host == "localhost" || host == "127.0.0.1" || host == "::1";
}

/// What a section requires, with the fields that take the place of parts of it.
std::vector<config::DeviceAddress> required_devices(const config::CfgSection& section,
                                                    const PassthroughOptions& options) {
  std::vector<config::DeviceAddress> required = section.addresses("requires");
  for (std::size_t i = 0; i < required.size(); ++i) {
    if (!options.remote_host.empty()) required[i].host = options.remote_host;
    if (section.has(kPort)) required[i].port = options.remote_port;
    if (i < options.remote_indices.size())
      required[i].index = static_cast<std::uint16_t>(options.remote_indices[i]);
  }
  return required;
}

Result<Section> read_section(const config::CfgSection& section, const PassthroughOptions& options,
                             const Site& site) {
  const std::vector<config::DeviceAddress> provided = section.addresses("provides");
  const std::vector<config::DeviceAddress> required = required_devices(section, options);
  const std::string where = section.at("requires");
  if (required.empty())
    return Error{where,
                 "driver \"passthrough\" requires devices of another server, e.g. [\"lab:6665:laser:0\"]" +
                     section.slip_for("requires")};
  if (required.size() != provided.size())
    return Error{where, fmt::format("{} devices are provided and {} required: each stands for one",
                                    provided.size(), required.size())};
  if (const std::size_t indices = options.remote_indices.size(); indices > 0 && indices != required.size())
    return Error{section.at(kIndex),
                 fmt::format("{} devices are required and {} indices given: one is of each", required.size(),
                             indices)};
  Section read;
  for (std::size_t i = 0; i < required.size(); ++i) {
    const Result<device::Address> here = site.resolve(provided[i]);
    if (!here) return Error{section.at("provides"), here.error().text};
    const Result<device::Address> there = resolved(site, required[i]);
    if (!there) return Error{where, there.error().text};
    const std::string host = required[i].host.empty() ? "localhost" : required[i].host;
    const auto port = static_cast<std::uint16_t>(there->robot);
    if (required[i].port == 0)
      return Error{where, fmt::format("{} has an invalid port: 1 to {} is valid",
                                      in_quotes(required[i].text()), kLargestNumber)};
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

constinit const DriverDefinition kPassthroughDriver{
    .name = "passthrough",
    .doc = "Forwards devices of another Player server, this program or any.",
    .provides = kPassthroughProvides,
    .uses = kPassthroughUses,
    .properties = kRemoteProperties,
    .read_options = reading<passthrough_options>,
    .make = make_passthrough,
    .make_remote = make_remote_devices,
};

Result<std::unique_ptr<device::Driver>> make_passthrough(const config::CfgSection& section, Site& site) {
  const Result<PassthroughOptions> options = passthrough_options(section);
  if (!options) return options.error();
  const Result<Section> read = read_section(section, *options, site);
  if (!read) return read.error();
  auto driver = std::make_unique<Passthrough>(site, read->host, read->port, options->after_loss);
  const Result<std::shared_ptr<net::TlsTrust>> trust = read_trust(section, options->tls_ca);
  if (!trust) return trust.error();
  driver->remote().set_token(options->token);
  driver->remote().set_trust(*trust);
  if (!options->connects) driver->start_disconnected();
  for (std::size_t i = 0; i < read->here.size(); ++i)
    if (const Result<void> added = driver->add(read->here[i], read->there[i]); !added)
      return Error{section.at("provides"), added.error().text};
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
  for (auto& [port, server] : servers) drivers.push_back(std::move(server));
  return drivers;
}

}  // namespace playhouse::drivers
