#include "playhouse/drivers/dummy/dummy.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "playhouse/base/in_quotes.h"
#include "playhouse/base/limits.h"
#include "playhouse/drivers/dummy/wire_fields.h"
#include "playhouse/drivers/section_fields.h"
#include "playhouse/wire/codec.h"
#include "playhouse/wire/generated/common.h"
#include "playhouse/wire/generated/map.h"
#include "playhouse/wire/generated/player.h"
#include "playhouse/wire/generated/simulation.h"

namespace playhouse::drivers {
namespace {

constexpr double kSlowest = 0.01, kFastest = 1000;  // Hz
constexpr std::size_t kEntryBytes = 256;            // of what is remembered, besides its body
constexpr std::string_view kMapTile = "map::Data", kModelProperty = "simulation::PropertyReq";

/// Requests that read a property, and those that set it.
constexpr std::pair<std::uint8_t, std::uint8_t> kPropertyRequests[] = {
    {wire::kReqGetBoolprop, wire::kReqSetBoolprop},
    {wire::kReqGetDblprop, wire::kReqSetDblprop},
    {wire::kReqGetIntprop, wire::kReqSetIntprop},
    {wire::kReqGetStrprop, wire::kReqSetStrprop},
    {wire::simulation::kReqGetProperty, wire::simulation::kReqSetProperty},
};

/// A request for its payload, which sets nothing whatever its body says.
bool is_question(const wire::MessageDef& message) {
  return std::ranges::any_of(wire_questions(), [&](const WireQuestion& question) {
    return question.interf == message.interf && question.subtype == message.subtype;
  });
}

/// A named property: of any device, or of a model.
struct Property {
  std::uint8_t read_by;  // the request that reads it
  bool is_set;           // rather than read
  std::string key;
};

/// None if the request is for no property, or names none.
std::optional<Property> property_of(const wire::MessageDef& request, std::span<const std::byte> body) {
  if (request.interf != 0 && request.payload != kModelProperty) return std::nullopt;
  Property property{request.subtype, false, {}};
  for (const auto& [read, set] : kPropertyRequests)
    if (request.subtype == set) property = {read, true, {}};
  // Names are the first fields of each of these payloads.
  wire::Reader reader(body);
  for (int names = request.interf == 0 ? 1 : 2; names > 0; --names) {
    std::uint32_t count = 0;
    std::string name;
    reader.read(count);
    reader.read_bytes(name, reader.dynamic_length("name", count, 1));
    property.key += wire::c_string(wire::text(name));
  }
  return reader.ok() ? std::optional(std::move(property)) : std::nullopt;
}

/// The cells of a rectangle of the map; none if a part of it is elsewhere.
std::optional<Bytes> map_cells(const GridMap& map, const wire::map::Data& asked) {
  const bool is_inside = std::uint64_t{asked.col} + asked.width <= map.info.width &&
                         std::uint64_t{asked.row} + asked.height <= map.info.height;
  if (!is_inside) return std::nullopt;
  const std::optional<wire::map::Data> tile = map_tile(map, asked);
  return tile ? std::optional(wire::encode(*tile)) : std::nullopt;
}

/// Keeps a body unless the device then has more than its limit.
template <typename Map>
bool keep_body(Map& bodies, typename Map::key_type key, std::span<const std::byte> body, std::size_t& bytes) {
  const auto found = bodies.find(key);
  const std::size_t old = found == bodies.end() ? 0 : found->second.size() + kEntryBytes;
  if (bytes - old + body.size() + kEntryBytes > limits::kDummyBytes) return false;
  bytes += body.size() + kEntryBytes - old;
  bodies[std::move(key)].assign(body.begin(), body.end());
  return true;
}

}  // namespace

Result<void> Dummy::add(device::Address address) {
  const Result<device::DeviceId> id = site_.add_device(address, *this);
  if (!id) return id.error();
  const std::lock_guard lock(mutex_);
  devices_.emplace(*id, DummyDevice{address.interf, Plausible(seed_, address), {}, {}});
  return {};
}

void Dummy::forget(device::DeviceId id) {
  const std::lock_guard lock(mutex_);
  devices_.erase(id);
}

/// Null: its interface has no such message, or the device has retired.
const wire::MessageDef* Dummy::definition(device::DeviceId id, std::uint8_t type,
                                          std::uint8_t subtype) const {
  const auto found = devices_.find(id);
  if (found == devices_.end()) return nullptr;
  return wire::find_message(found->second.interf, static_cast<wire::MessageType>(type), subtype);
}

Result<void> Dummy::start(device::DeviceId id) {
  net::Network& network = site_.surroundings().network();
  // Not at once: who opens it hears of it when this is done.
  open_[id] = {0, network.now(), network.after(0, [this, id] { send(id); })};
  return {};
}

void Dummy::send(device::DeviceId id) {
  Open& open = open_.at(id);
  const DummyDevice& device = devices_.at(id);
  const double time = site_.time();
  std::vector<device::Publication> batch;
  for (const wire::MessageDef& message : wire::find_interface(device.interf)->messages)
    if (message.type == wire::MessageType::kData)
      batch.push_back({id, message.subtype, time, device.values.body(message, open.number)});
  if (batch.empty()) return;
  ++open.number;
  // What a busy program was too late for is left out.
  net::Network& network = site_.surroundings().network();
  open.due = std::max(open.due + period_, network.now());
  open.timer = network.after(open.due - network.now(), [this, id] { send(id); });
  site_.data_flow().publish(std::move(batch));
}

device::Taken Dummy::command(const device::Message& message) {
  const std::lock_guard lock(mutex_);
  const wire::MessageDef* const known = definition(message.device, message.type, message.subtype);
  return known != nullptr && known->check(message.body).empty() ? device::Taken::kLatest : device::Taken::kNo;
}

void Dummy::request(const device::Message& message, device::Replier replier) {
  std::optional<Bytes> body;
  {
    const std::lock_guard lock(mutex_);
    const wire::MessageDef* const known = definition(message.device, message.type, message.subtype);
    if (known == nullptr || !known->check(message.body).empty()) return;
    body = answer(devices_.at(message.device), *known, message.body);
  }
  if (body) replier.ack(std::move(*body));
}

/// None: NACK.
std::optional<Bytes> Dummy::answer(DummyDevice& device, const wire::MessageDef& known,
                                   std::span<const std::byte> body) {
  if (const std::optional<Property> property = property_of(known, body)) {
    const std::pair<std::uint8_t, std::string> key{property->read_by, property->key};
    if (property->is_set && !keep_body(device.properties, key, known.reencode(body), device.set_bytes))
      return std::nullopt;
    const auto found = device.properties.find(key);
    return found == device.properties.end() ? std::nullopt : std::optional(found->second);
  }
  if (known.interf == 0) return std::nullopt;
  if (known.has_payload && !body.empty()) {
    if (!is_question(known)) {
      Bytes canonical = known.reencode(body);
      if (!keep_body(device.set, known.payload, canonical, device.set_bytes)) return std::nullopt;
      return canonical;
    }
    if (known.payload == kMapTile)
      return map_cells(plausible_map(device.values.device()), *wire::decode<wire::map::Data>(body));
  }
  const auto set = device.set.find(known.payload);
  return set != device.set.end() ? set->second : device.values.body(known, 0);
}

bool Dummy::capable(device::DeviceId id, std::uint8_t type, std::uint8_t subtype) const {
  const std::lock_guard lock(mutex_);
  return definition(id, type, subtype) != nullptr;
}

// --- sections of configuration files

namespace {

constexpr DeviceText kDummyProvides[] = {{{}, {}, HowMany::kAny, "but player, which is the server itself"}};

struct DummyOptions {
  double rate = 10;  // Hz
  int seed = 0;
};

Result<DummyOptions> dummy_options(SectionFields fields) {
  DummyOptions options;
  options.rate =
      fields.number({"rate", "How often each DATA message of an open device comes, 1000 at most.", "Hz"},
                    options.rate, kSlowest);
  fields.expect(options.rate <= kFastest, "rate", "is at most 1000");
  options.seed = fields.integer({"seed", "Another one gives other values."}, options.seed, 0,
                                std::numeric_limits<int>::max());
  if (const Result<void> fault = fields.fault(); !fault) return fault.error();
  return options;
}

}  // namespace

constinit const DriverDefinition kDummyDriver{
    .name = "dummy",
    .doc = "Devices of any interface, without a robot: made-up data, for tests of a client or of a driver.",
    .provides = kDummyProvides,
    .read_options = reading<dummy_options>,
    .make = make_dummy,
};

Result<std::unique_ptr<device::Driver>> make_dummy(const config::CfgSection& section, Site& site) {
  const Result<DummyOptions> options = dummy_options(section);
  if (!options) return options.error();
  auto driver = std::make_unique<Dummy>(site, 1 / options->rate, static_cast<std::uint64_t>(options->seed));
  for (const config::DeviceAddress& provided : section.addresses("provides")) {
    const Result<device::Address> address = site.resolve(provided);
    if (!address) return Error{section.at("provides"), address.error().text};
    if (address->interf == wire::player::kCode)
      return Error{section.at("provides"),
                   in_quotes(provided.text()) + " is the server itself, no device of a driver"};
    if (const Result<void> added = driver->add(*address); !added)
      return Error{section.at("provides"), added.error().text};
  }
  return std::unique_ptr<device::Driver>(std::move(driver));
}

}  // namespace playhouse::drivers
