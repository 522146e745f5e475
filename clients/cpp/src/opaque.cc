#include "playhouse_client/opaque.h"

#include <utility>

#include "done.h"
#include "playhouse/base/limits.h"
#include "playhouse/wire/codec.h"

namespace playhouse::client {

namespace opaque = wire::opaque;

namespace {

constexpr std::size_t kLengthBytes = 8;  // length prefix of the payload: the byte count, sent twice

/// The message's payload, or an error if it exceeds the protocol's limit.
Result<opaque::Data> on_wire(const Device& device, std::string_view bytes) {
  if (bytes.size() > limits::kBodyBytes - kLengthBytes)
    return Error{"", device.name() + ": a message of " + std::to_string(bytes.size()) +
                         " bytes is over the wire's limit"};
  return opaque::Data{{bytes.begin(), bytes.end()}};
}

}  // namespace

Result<Opaque> Opaque::open(Client& client, std::uint16_t index, Access access) {
  Result<Device> device = Device::open(client, opaque::kCode, index, access);
  if (!device) return device.error();
  return Opaque(std::move(*device));
}

Opaque::Opaque(Device device) : device_(std::move(device)) {
  device_.keep(kWaiting);
}

Result<void> Opaque::send(std::string_view message) {
  const auto data = on_wire(device_, message);
  return data ? device_.command(opaque::kCmdData, *data) : data.error();
}

Result<void> Opaque::send_to(std::string_view address, std::string_view message) {
  const auto data = on_wire(device_, wire::c_string(address).append(message));
  if (!data) return data.error();
  return done(device_.request(opaque::kReqData, *data));
}

std::vector<std::string> Opaque::take_messages() {
  std::vector<std::string> taken;
  for (const std::vector<std::byte>& body : device_.take_kept()) {
    const opaque::Data data = *wire::decode<opaque::Data>(body);  // validated on arrival
    taken.emplace_back(data.data.begin(), data.data.end());
  }
  return taken;
}

}  // namespace playhouse::client
