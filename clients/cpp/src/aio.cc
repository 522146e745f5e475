#include "playhouse_client/aio.h"

#include <utility>

#include "finite.h"

namespace playhouse::client {

namespace aio = wire::aio;

Result<Aio> Aio::open(Client& client, std::uint16_t index, Access access) {
  Result<Device> device = Device::open(client, aio::kCode, index, access);
  if (!device) return device.error();
  return Aio(std::move(*device));
}

std::vector<double> Aio::voltages() const {
  const auto data = device_.latest<aio::Data>(aio::kDataState);
  return data ? std::vector<double>(data->voltages.begin(), data->voltages.end()) : std::vector<double>();
}

Result<void> Aio::set(std::uint32_t output, double voltage) {
  if (const auto sound = finite_floats(device_, "set", {voltage}); !sound) return sound;
  return device_.command(aio::kCmdState, aio::Cmd{output, static_cast<float>(voltage)});
}

}  // namespace playhouse::client
