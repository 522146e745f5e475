#include "convert.h"

#include "playhouse/base/limits.h"
#include "playhouse/wire/generated/wifi.h"
#include "playhouse_client/scan.h"

namespace playhouse::client {

namespace {

constexpr std::size_t kLengthBytes = 8;  // length prefix of the payload: the byte count, sent twice

}  // namespace

Charging charging(std::int32_t state) {
  if (state < 0) return Charging::kImpossible;
  return state > 0 ? Charging::kYes : Charging::kNo;
}

std::int64_t level(std::int32_t value, std::uint32_t unit) {
  return unit == wire::wifi::kQualDbm ? std::int64_t{value} : std::int64_t{static_cast<std::uint32_t>(value)};
}

std::vector<double> directions(double low, double high, std::size_t count,
                               const std::vector<wire::Pose3d>& elements) {
  if (elements.size() != count || count < 2) return spread_angles(low, high, count);
  return each(elements, [](const wire::Pose3d& element) { return element.pyaw; });
}

Result<std::vector<std::uint8_t>> bytes_on_wire(const Device& device, std::string_view bytes) {
  if (bytes.size() > limits::kBodyBytes - kLengthBytes)
    return Error{"", device.name() + ": a message of " + std::to_string(bytes.size()) +
                         " bytes is over the wire's limit"};
  return std::vector<std::uint8_t>(bytes.begin(), bytes.end());
}

}  // namespace playhouse::client
