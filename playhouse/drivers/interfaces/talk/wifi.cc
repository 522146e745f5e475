/// A radio as interface wifi (docs/drivers.md).

#include "playhouse/wire/generated/wifi.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "playhouse/drivers/generated/device_makers.h"
#include "playhouse/drivers/interfaces/talk/radio_address.h"

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

class Wifi final : public SimulatedDevice {
 public:
  Wifi(run::Simulation& simulation, world::ModelRow model)
      : SimulatedDevice(simulation, simulation.world().id(model)) {
    const world::World& world = simulation.world();
    address_ = wire::encode(wf::MacReq{text_of(mac_of(world, model))});
    bitrate_ = static_cast<std::uint32_t>(world.desc(model).wifi->bitrate);
  }

  std::span<const Served> served() const override {
    static constexpr Served kServed[] = {{MessageType::kReq, wf::kReqMac}};
    return kServed;
  }
  void request(const device::Message&, device::Replier replier) override { replier.ack(address_); }

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
    for (const world::WifiLink& link : world.wifis.links[radio]) data.links.push_back(link_of(world, link));
    publish(world, wf::kDataState, data, out);
  }

 private:
  Bytes address_;
  std::uint32_t bitrate_ = 0;  // bit/s
};

}  // namespace

std::unique_ptr<SimulatedDevice> make_wifi_device(run::Simulation& simulation, world::ModelRow model) {
  return std::make_unique<Wifi>(simulation, model);
}

}  // namespace playhouse::drivers
