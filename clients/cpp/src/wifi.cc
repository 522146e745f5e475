#include "playhouse_client/wifi.h"

#include <string_view>
#include <utility>

namespace playhouse::client {

namespace wf = wire::wifi;

namespace {

std::string text_of(const std::vector<std::uint8_t>& bytes) {
  const std::string raw(bytes.begin(), bytes.end());
  return std::string(wire::text(raw));
}

/// Levels in dBm are signed, all others are not.
std::int64_t level_of(std::int32_t value, std::uint32_t unit) {
  return unit == wf::kQualDbm ? std::int64_t{value} : std::int64_t{static_cast<std::uint32_t>(value)};
}

Link link_of(const wf::Link& one, std::uint32_t unit) {
  return {.mac = text_of(one.mac),
          .ip = text_of(one.ip),
          .essid = text_of(one.essid),
          .mode = one.mode,
          .frequency = one.freq,
          .encrypted = one.encrypt != 0,
          .quality = one.qual,
          .level = level_of(one.level, unit),
          .noise = level_of(one.noise, unit)};
}

}  // namespace

Result<Wifi> Wifi::open(Client& client, std::uint16_t index, Access access) {
  Result<Device> device = Device::open(client, wf::kCode, index, access);
  if (!device) return device.error();
  return Wifi(std::move(*device));
}

std::optional<WifiState> Wifi::state() const {
  const auto data = device_.latest<wf::Data>(wf::kDataState);
  if (!data) return std::nullopt;
  WifiState state{.links = {},
                  .throughput = data->throughput,
                  .bitrate = data->bitrate,
                  .mode = data->mode,
                  .unit = data->qual_type,
                  .max_quality = data->maxqual,
                  .max_level = level_of(data->maxlevel, data->qual_type),
                  .max_noise = level_of(data->maxnoise, data->qual_type),
                  .access_point = std::string(wire::text(data->ap)),
                  .time = device_.timestamp()};
  for (const wf::Link& one : data->links) state.links.push_back(link_of(one, data->qual_type));
  return state;
}

std::vector<Link> Wifi::links() const {
  auto newest = state();
  return newest ? std::move(newest->links) : std::vector<Link>();
}

Result<std::string> Wifi::mac() {
  const auto answer = device_.request<wf::MacReq>(wf::kReqMac);
  if (!answer) return answer.error();
  return text_of(answer->mac);
}

}  // namespace playhouse::client
