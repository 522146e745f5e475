#include "playhouse/server/multicast_group.h"

#include <fmt/format.h>

#include <utility>

#include "playhouse/base/limits.h"
#include "playhouse/base/log.h"

namespace playhouse::server {

Result<std::unique_ptr<MulticastGroup>> MulticastGroup::open(net::Network& network, const std::string& bind,
                                                             const net::Endpoint& group) {
  const std::string from = bind == "::" ? "0.0.0.0" : bind;
  auto socket = network.open_datagrams(from, 0, [](const net::Endpoint&, std::span<const std::byte>) {});
  if (!socket) return socket.error();
  return std::make_unique<MulticastGroup>(std::move(*socket), group);
}

MulticastGroup::MulticastGroup(std::unique_ptr<net::DatagramSocket> socket, const net::Endpoint& group)
    : socket_(std::move(socket)),
      group_(group),
      place_(fmt::format("{} from {}", net::to_text(group), socket_->port())) {}

bool MulticastGroup::carries(const Frame& frame) const {
  return frame.bytes->size() <= limits::kDatagramMostBytes;
}

void MulticastGroup::send(const Frame& frame, std::uint32_t number) {
  if (socket_->send(group_, numbered(*frame.bytes, number))) return static_cast<void>(++counts_.sent);
  if (counts_.unsent++ == 0)
    log::warn("multicast: the system does not take what goes to {}: no route there, or no room (logged once)",
              net::to_text(group_));
}

}  // namespace playhouse::server
