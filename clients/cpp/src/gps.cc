#include "playhouse_client/gps.h"

#include <utility>

namespace playhouse::client {

namespace gps = wire::gps;

namespace {
constexpr double kDegrees = 1e-7, kMetres = 1e-3;  // units of the wire
}

Result<Gps> Gps::open(Client& client, std::uint16_t index, Access access) {
  Result<Device> device = Device::open(client, gps::kCode, index, access);
  if (!device) return device.error();
  return Gps(std::move(*device));
}

std::optional<Fix> Gps::fix() const {
  const auto data = device_.latest<gps::Data>(gps::kDataState);
  if (!data) return std::nullopt;
  return Fix{.latitude = data->latitude * kDegrees,
             .longitude = data->longitude * kDegrees,
             .altitude = data->altitude * kMetres,
             .easting = data->utm_e,
             .northing = data->utm_n,
             .speed = data->speed,
             .course = data->course,
             .quality = data->quality,
             .satellites = data->num_sats,
             .horizontal_error = data->err_horz,
             .vertical_error = data->err_vert,
             .time = device_.timestamp()};
}

}  // namespace playhouse::client
