#include "playhouse/server/multicast_group.h"

#include <fmt/format.h>

#include <string_view>
#include <utility>

#include "playhouse/base/limits.h"
#include "playhouse/base/log.h"

namespace playhouse::server {
namespace {

constexpr std::string_view kEveryAddress = "0.0.0.0";

/// As place() tells it: the system chooses among several addresses.
std::string sender_text(const std::string& from, std::uint16_t port) {
  const Result<net::Endpoint> own = net::parse_endpoint(from, port);
  return own && from != kEveryAddress ? net::to_text(*own) : std::to_string(port);
}

}  // namespace

Result<std::unique_ptr<MulticastGroup>> MulticastGroup::open(net::Network& network, const std::string& bind,
                                                             const net::Endpoint& group) {
  const std::string from = bind == "::" ? std::string(kEveryAddress) : bind;
  auto socket = network.open_datagrams(from, 0, [](const net::Endpoint&, std::span<const std::byte>) {});
  if (!socket) return socket.error();
  const std::string sender = sender_text(from, (*socket)->port());
  return std::make_unique<MulticastGroup>(std::move(*socket), sender, group);
}

MulticastGroup::MulticastGroup(std::unique_ptr<net::DatagramSocket> socket, const std::string& sender,
                               const net::Endpoint& group)
    : socket_(std::move(socket)),
      group_(group),
      place_(fmt::format("{} from {}", net::to_text(group), sender)) {}

bool MulticastGroup::carries(const Frame& frame) const {
  return frame.bytes->size() <= limits::kDatagramMostBytes;
}

bool MulticastGroup::send(const Frame& frame, std::uint32_t number) {
  if (socket_->send(group_, numbered(*frame.bytes, number))) {
    ++counts_.sent;
    return true;
  }
  if (counts_.unsent++ == 0)
    log::warn(
        "multicast: the system does not take what goes to {}, no route there or no room: it goes to "
        "each client (logged once)",
        net::to_text(group_));
  return false;
}

}  // namespace playhouse::server
