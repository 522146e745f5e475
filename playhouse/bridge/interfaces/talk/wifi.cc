/// A radio as interface wifi (docs/drivers.md).

#include "playhouse/wire/generated/wifi.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <string_view>
#include <utility>

#include "playhouse/bridge/generated/device_makers.h"
#include "playhouse/bridge/interfaces/talk/radio_address.h"
#include "playhouse/bridge/settings/settings.h"

namespace playhouse::drivers {
namespace {

namespace wf = wire::wifi;
using wire::MessageType;

constexpr std::int32_t kNoise = -100;  // dBm, constant noise level of a receiver

/// Truncated to the length of an address.
std::vector<std::uint8_t> text_of(const std::string& text) {
  constexpr std::size_t kMost = 32;
  return {text.begin(), text.begin() + static_cast<std::ptrdiff_t>(std::min(text.size(), kMost))};
}

wf::Link link_of(const world::World& world, const world::WifiLink& link) {
  const world::ModelRow station = world.row(link.station);
  if (!station) return {};
  const scene::WifiDesc& desc = *world.desc(station).wifi;
  wf::Link item;
  item.mac = text_of(mac_of(world, station));
  item.ip = text_of(ip_of(world, station));
  item.essid = text_of(desc.essid);
  item.mode = wf::kModeAdhoc;
  item.freq = static_cast<std::uint32_t>(desc.frequency);
  item.qual = link.quality;
  item.level = static_cast<std::int32_t>(std::lround(link.level));
  item.noise = kNoise;
  return item;
}

constexpr std::size_t kWatched = 8;  // addresses, as of iwspy

/// Addresses whose links are reported; none: all links are.
struct WifiSettings {
  std::array<std::string, kWatched> watched;
};

std::string in_lower_case(std::string text) {
  for (char& c : text)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return text;
}

/// Six hexadecimal bytes.
bool is_address(std::string_view text) {
  if (text.size() != 17) return false;
  for (std::size_t i = 0; i < text.size(); ++i)
    if (i % 3 == 2 ? text[i] != ':' : std::string_view("0123456789abcdef").find(text[i]) == std::string::npos)
      return false;
  return true;
}

/// The address of a request in lower case; empty if it is none.
std::string address_of(const device::Message& message) {
  const auto value = wire::decode<wf::IwspyAddrReq>(message.body);
  if (!value) return {};
  std::string address = in_lower_case(std::string(wire::text(value->address)));
  return is_address(address) ? address : std::string();
}

bool watch(WifiSettings& wanted, const std::string& address) {
  if (std::ranges::find(wanted.watched, address) != wanted.watched.end()) return true;
  const auto free = std::ranges::find(wanted.watched, "");
  if (free == wanted.watched.end()) return false;
  *free = address;
  return true;
}

bool unwatch(WifiSettings& wanted, const std::string& address) {
  const auto found = std::ranges::find(wanted.watched, address);
  if (found == wanted.watched.end()) return false;
  found->clear();
  return true;
}

class Wifi final : public DeviceWithSettings<WifiSettings> {
 public:
  Wifi(run::Simulation& simulation, world::ModelRow model)
      : DeviceWithSettings(simulation, simulation.world().id(model), WifiSettings{}) {
    const world::World& world = simulation.world();
    address_ = wire::encode(wf::MacReq{text_of(mac_of(world, model))});
    bitrate_ = static_cast<std::uint32_t>(world.desc(model).wifi->bitrate);
  }

  std::span<const Served> served() const override {
    static constexpr Served kServed[] = {
        {MessageType::kReq, wf::kReqMac},
        {MessageType::kReq, wf::kReqIwspyAdd},
        {MessageType::kReq, wf::kReqIwspyDel},
        {MessageType::kReq, wf::kReqIwspyPing},
    };
    return kServed;
  }
  void request(const device::Message& message, device::Replier replier) override {
    if (message.subtype == wf::kReqMac) return replier.ack(address_);
    const std::string address = address_of(message);
    if (address.empty()) return;
    if (message.subtype == wf::kReqIwspyPing) return ping(address, std::move(replier));
    const bool adds = message.subtype == wf::kReqIwspyAdd;
    change_settings(std::move(replier), [adds, address](WifiSettings& wanted) {
      return adds ? watch(wanted, address) : unwatch(wanted, address);
    });
  }

  void emit(const world::World& world, std::vector<device::Publication>& out) override {
    const world::ModelRow row = world.row(model());
    if (!row) return;
    const world::WifiRow radio = world.models.part[row];
    if (world.wifis.measured_tick[radio] != world.tick()) return;
    wf::Data data;
    data.throughput = data.bitrate = bitrate_;
    data.mode = wf::kModeAdhoc;
    data.qual_type = wf::kQualDbm;
    data.maxqual = 100;
    for (const world::WifiLink& link : world.wifis.links[radio])
      if (is_watched(world, link)) data.links.push_back(link_of(world, link));
    publish(world, wf::kDataState, data, out);
  }

 private:
  bool settle(WifiSettings&) const override { return true; }

  /// ACK if the radio with that address was received in the newest measurement.
  void ping(const std::string& address, device::Replier replier) const {
    ask_world(std::move(replier), [id = model(), address](const world::World& world) -> std::optional<Bytes> {
      const world::ModelRow row = world.row(id);
      if (!row) return std::nullopt;
      for (const world::WifiLink& link : world.wifis.links[world.models.part[row]])
        if (has_address(world, link, address)) return Bytes();
      return std::nullopt;
    });
  }
  static bool has_address(const world::World& world, const world::WifiLink& link, std::string_view address) {
    const world::ModelRow station = world.row(link.station);
    return station && in_lower_case(mac_of(world, station)) == address;
  }
  bool is_watched(const world::World& world, const world::WifiLink& link) const {
    bool watches = false;
    for (const std::string& address : settings().watched) {
      if (address.empty()) continue;
      watches = true;
      if (has_address(world, link, address)) return true;
    }
    return !watches;
  }

  Bytes address_;
  std::uint32_t bitrate_ = 0;  // bit/s
};

}  // namespace

std::unique_ptr<SimulatedDevice> make_wifi_device(run::Simulation& simulation, world::ModelRow model) {
  return std::make_unique<Wifi>(simulation, model);
}

}  // namespace playhouse::drivers
