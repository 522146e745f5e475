#include "playhouse/observers/observer_client.h"

#include <utility>

#include "playhouse/observers/cookie.h"

namespace playhouse::observers {
namespace {

constexpr double kLookPeriod = 0.01;  // s, poll period
constexpr int kGoodbyes = 3;          // sent repeatedly against loss

}  // namespace

Result<std::unique_ptr<ObserverClient>> ObserverClient::open(net::Network& network,
                                                             const net::Endpoint& server,
                                                             replicate::Terms wanted, std::string token,
                                                             std::function<void()> turn,
                                                             const std::string& bind) {
  std::unique_ptr<ObserverClient> client(
      new ObserverClient(network, server, wanted, std::move(token), std::move(turn)));
  const std::string here = !bind.empty() ? bind : server.is_v4() ? "0.0.0.0" : "::";
  auto socket = network.open_datagrams(
      here, 0, [raw = client.get()](const net::Endpoint& from, std::span<const std::byte> bytes) {
        raw->received(from, bytes);
      });
  if (!socket) return socket.error();
  client->socket_ = std::move(*socket);
  client->timer_ = network.after(0, [raw = client.get()] { raw->look_at_clock(); });
  return client;
}

ObserverClient::ObserverClient(net::Network& network, const net::Endpoint& server, replicate::Terms wanted,
                               std::string token, std::function<void()> turn)
    : network_(network),
      server_(server),
      turn_(std::move(turn)),
      observer_(random_number(), wanted, std::move(token), network.now()) {}

void ObserverClient::received(const net::Endpoint& from, std::span<const std::byte> bytes) {
  if (from != server_) return;
  observer_.receive(bytes, network_.now());
  send_due();
  const auto turn = turn_;  // copied: it may destroy us
  turn();
}

void ObserverClient::look_at_clock() {
  send_due();
  timer_ = network_.after(kLookPeriod, [this] { look_at_clock(); });
  const auto turn = turn_;
  turn();
}

void ObserverClient::send_due() {
  while (const auto datagram = observer_.next(network_.now())) socket_->send(server_, *datagram);
}

void ObserverClient::leave() {
  const auto bye = observer_.bye();
  for (int times = 0; bye && times < kGoodbyes; ++times) socket_->send(server_, *bye);
}

}  // namespace playhouse::observers
