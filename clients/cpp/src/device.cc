#include "playhouse_client/device.h"

#include <utility>

#include "done.h"
#include "playhouse/wire/generated/player.h"
#include "playhouse_client/client.h"
#include "session.h"

namespace playhouse::client {

namespace player = wire::player;

namespace {

constexpr std::uint8_t kCloseAccess = player::kCloseMode;

/// Requests an access mode (open or close); returns the driver's name, or the reason of a refusal.
Result<std::string> set_access(Session& session, const Slot& slot, std::uint8_t access) {
  player::DeviceReq body;
  body.addr.interf = slot.interf;
  body.addr.index = slot.index;
  body.access = access;
  const auto answer = session.request(player::kCode, 0, player::kReqDev, wire::encode(body));
  if (!answer) return answer.error();
  const auto granted = wire::decode<player::DeviceReq>(*answer);
  if (!granted)
    return Error{session.connection().peer(), "the answer does not decode: " + granted.error().text};
  if (granted->access == player::kErrorMode) return Error{session.connection().peer(), "the driver refuses"};
  return std::string(wire::text(granted->driver_name));
}

std::string name_of(const Slot& slot) {
  return DeviceAddress{0, slot.interf, slot.index}.name();
}

}  // namespace

Result<Device> Device::open(Client& client, std::uint16_t interf, std::uint16_t index, Access access) {
  return open(client.session_, interf, index, access);
}

Result<Device> Device::open(const std::shared_ptr<Session>& shared, std::uint16_t interf, std::uint16_t index,
                            Access access) {
  auto slot = std::make_unique<Slot>();
  slot->interf = interf;
  slot->index = index;
  Session& session = *shared;
  Result<std::string> driver = set_access(session, *slot, static_cast<std::uint8_t>(access));
  if (!driver)
    return Error{driver.error().where, "cannot open " + name_of(*slot) + ": " + driver.error().text};
  slot->driver = std::move(*driver);
  session.add(*slot);
  return Device(shared, std::move(slot));
}

Device::Device(std::shared_ptr<Session> session, std::unique_ptr<Slot> slot)
    : session_(std::move(session)), slot_(std::move(slot)), name_(name_of(*slot_)) {}

Device::Device(Device&&) noexcept = default;

Device& Device::operator=(Device&& other) noexcept {
  if (this == &other) return *this;
  static_cast<void>(close().ok());
  session_ = std::move(other.session_);
  slot_ = std::move(other.slot_);
  name_ = std::move(other.name_);
  return *this;
}

Device::~Device() {
  static_cast<void>(close().ok());
}

std::uint16_t Device::interf() const {
  return is_open() ? slot_->interf : std::uint16_t{0};
}
std::uint16_t Device::index() const {
  return is_open() ? slot_->index : std::uint16_t{0};
}
bool Device::connected() const {
  return is_open() && session_->connection().is_open();
}
bool Device::gone() const {
  return is_open() && !slot_->gone.empty();
}
std::string Device::driver() const {
  return is_open() ? slot_->driver : "";
}
double Device::timestamp() const {
  return is_open() ? slot_->timestamp : 0;
}

bool Device::take_fresh() {
  return is_open() && std::exchange(slot_->fresh, false);
}

void Device::on_data(OnData callback) {
  if (is_open()) slot_->on_data = std::move(callback);
}

Result<void> Device::close() {
  if (!is_open()) return {};
  session_->remove(*slot_);
  const std::unique_ptr<Slot> slot = std::move(slot_);
  if (!slot->gone.empty() || !session_->connection().is_open()) return {};
  const Result<std::string> closed = set_access(*session_, *slot, kCloseAccess);
  if (closed) return {};
  return Error{closed.error().where, "cannot close " + name_ + ": " + closed.error().text};
}

Result<Device::Bytes> Device::request_bytes(std::uint8_t subtype, std::span<const std::byte> body) {
  if (const Result<void> fit = usable(); !fit) return fit.error();
  return session_->request(slot_->interf, slot_->index, subtype, body);
}

Result<std::optional<Device::Bytes>> Device::ask_bytes(std::uint8_t subtype,
                                                       std::span<const std::byte> body) {
  if (const Result<void> fit = usable(); !fit) return fit.error();
  return session_->ask(slot_->interf, slot_->index, subtype, body, deadline_after(session_->timeout()));
}

Result<void> Device::command_bytes(std::uint8_t subtype, std::span<const std::byte> body) {
  if (const Result<void> fit = usable(); !fit) return fit;
  wire::Header header;
  header.interf = slot_->interf;
  header.index = slot_->index;
  header.type = wire::MessageType::kCmd;
  header.subtype = subtype;
  return session_->send(header, body);
}

const std::vector<std::byte>* Device::latest_bytes(std::uint8_t subtype) const {
  if (!is_open()) return nullptr;
  const auto found = slot_->latest.find(subtype);
  return found == slot_->latest.end() ? nullptr : &found->second.body;
}

void Device::keep(std::size_t most) {
  slot_->kept_limit = most;
}

std::deque<Device::Bytes> Device::take_kept() {
  return is_open() ? std::exchange(slot_->kept, {}) : std::deque<Bytes>();
}

double Device::timestamp(std::uint8_t subtype) const {
  if (!is_open()) return 0;
  const auto found = slot_->latest.find(subtype);
  return found == slot_->latest.end() ? 0 : found->second.timestamp;
}

Result<void> Device::usable() const {
  if (!is_open()) return Error{"", name_.empty() ? "the device is closed" : name_ + " is closed"};
  if (gone()) return Error{"", slot_->gone};
  return {};
}

Error Device::undecoded(std::uint8_t subtype, std::string_view what) const {
  return Error{session_->connection().peer(), "the answer to request " + std::to_string(subtype) + " of " +
                                                  name() + " does not decode: " + std::string(what)};
}

namespace {

/// Reads a property with the request of its type.
template <typename Req>
Result<Req> get(Device& device, std::uint8_t subtype, std::string_view key) {
  Req question;
  question.key = wire::c_string(key);
  return device.request<Req>(subtype, question);
}

template <typename Req, typename Value>
Result<void> set(Device& device, std::uint8_t subtype, std::string_view key, Value value) {
  Req body;
  body.key = wire::c_string(key);
  body.value = std::move(value);
  return done(device.request(subtype, body));
}

}  // namespace

Result<bool> Device::get_bool(std::string_view key) {
  const auto got = get<wire::BoolpropReq>(*this, wire::kReqGetBoolprop, key);
  if (!got) return got.error();
  return got->value != 0;
}

Result<std::int32_t> Device::get_int(std::string_view key) {
  const auto got = get<wire::IntpropReq>(*this, wire::kReqGetIntprop, key);
  if (!got) return got.error();
  return got->value;
}

Result<double> Device::get_double(std::string_view key) {
  const auto got = get<wire::DblpropReq>(*this, wire::kReqGetDblprop, key);
  if (!got) return got.error();
  return got->value;
}

Result<std::string> Device::get_string(std::string_view key) {
  const auto got = get<wire::StrpropReq>(*this, wire::kReqGetStrprop, key);
  if (!got) return got.error();
  return std::string(wire::text(got->value));
}

Result<void> Device::set_bool(std::string_view key, bool value) {
  return set<wire::BoolpropReq>(*this, wire::kReqSetBoolprop, key, static_cast<char>(value));
}

Result<void> Device::set_int(std::string_view key, std::int32_t value) {
  return set<wire::IntpropReq>(*this, wire::kReqSetIntprop, key, value);
}

Result<void> Device::set_double(std::string_view key, double value) {
  return set<wire::DblpropReq>(*this, wire::kReqSetDblprop, key, value);
}

Result<void> Device::set_string(std::string_view key, std::string_view value) {
  return set<wire::StrpropReq>(*this, wire::kReqSetStrprop, key, wire::c_string(value));
}

bool Device::has_capability(wire::MessageType type, std::uint8_t subtype) {
  wire::CapabilitiesReq body;
  body.type = static_cast<std::uint32_t>(type);
  body.subtype = subtype;
  return request(wire::kReqCapabilities, body).ok();
}

}  // namespace playhouse::client
